#include "input/QueryTable.h"

#include "input/ContentCheck.h"
#include "input/RunReader.h"
#include "program/Messages.h"

#include "vtkPointData.h"
#include "vtkPointTableReader.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"

#include <cstring>

namespace
{

/// The name of a file whose first bytes do not say that it is something else.
const std::string& checked(const std::string& fileName)
{
  checkContentFits(fileName);
  return fileName;
}

} // namespace

QueryTable::QueryTable(const std::string& fileName, bool withColumns, Messages& messages)
  : file_(checked(fileName))
  , reader_(vtkSmartPointer<vtkPointTableReader>::New())
{
  messages.setSubject(fileName);
  reader_->SetFileName(fileName.c_str());
  reader_->ReadNormalsAndAreasOff(); // a column "area" may have any words here
  reader_->SetReadAllColumns(withColumns);
  reader_->GenerateRowPlacesOn();
  runReader(reader_, fileName, messages);
  file_.checkName();
  vtkPointData* const arrays = reader_->GetOutput()->GetPointData();
  places_ = vtkTypeInt64Array::SafeDownCast(arrays->GetArray("RowPlace"));
  arrays->RemoveArray("RowPlace"); // it is no column
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
  return reader_->GetColumnNames()->LookupValue(name) >= 0;
}

std::string_view QueryTable::row(vtkIdType point)
{
  return file_.read(static_cast<std::size_t>(places_->GetTypedComponent(point, 0)),
    static_cast<std::size_t>(places_->GetTypedComponent(point, 1)));
}
