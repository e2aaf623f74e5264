// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/QueryTable.h"

#include "input/ReadInput.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkWindingNumberReader.h"

QueryTable::QueryTable(
  const std::string& fileName, With with, const std::string& columns, Messages& messages)
  : reader_(vtkSmartPointer<vtkWindingNumberReader>::New())
{
  reader_->ReadNormalsAndAreasOff(); // a column "area" may have any words here
  reader_->SetColumns(columns.c_str());
  reader_->SetReadAllColumns(with == With::columns);
  reader_->SetKeepRows(with == With::rows);
  readBy(reader_, fileName, messages);
  header_ = reader_->GetHeader();
  header_.pop_back();
  if (!header_.empty() && header_.back() == '\r')
  {
    header_.pop_back();
    lineEnd_ = "\r\n";
  }
}

QueryTable::~QueryTable() = default;

vtkPointSet* QueryTable::points() const
{
  return reader_->GetOutput();
}

bool QueryTable::hasColumn(const std::string& name) const
{
  return reader_->GetColumnNames()->LookupValue(name.c_str()) >= 0 ||
         reader_->GetOutput()->GetPointData()->HasArray(name.c_str()) != 0;
}

char QueryTable::separator() const
{
  return reader_->GetSeparator();
}

bool QueryTable::hasDecimalCommas() const
{
  return reader_->GetHasDecimalCommas();
}

std::string QueryTable::row(vtkIdType point) const
{
  return reader_->GetRow(point);
}
