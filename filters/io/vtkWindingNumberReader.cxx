// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWindingNumberReader.h"

#include "files/ColumnNames.h"
#include "files/MeshFormats.h"
#include "files/PointsFile.h"
#include "files/TableFile.h"
#include "messages/Options.h"
#include "pipeline/ErrorReports.h"
#include "pipeline/HostShare.h"
#include "pipeline/SmpExecutor.h"
#include "private/Gzip.h"
#include "private/HandedArrays.h"

#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkWindingNumberAlgorithm.h"

#include <map>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkWindingNumberReader);

namespace
{

/// Texts go straight into VTK's arrays, so that there is no second copy of them.
class StringArrays final : public winding::TextColumns
{
public:
  void add(std::size_t column, std::size_t rows) override
  {
    auto& array = arrays_[column];
    array = vtkSmartPointer<vtkStringArray>::New();
    array->SetNumberOfValues(static_cast<vtkIdType>(rows));
  }

  /// VTK's arrays may be written to by several threads as long as nobody has looked values up.
  void set(std::size_t column, std::size_t row, const std::string& text) override
  {
    arrays_.find(column)->second->SetValue(static_cast<vtkIdType>(row), text);
  }

  vtkStringArray* of(std::size_t column) { return arrays_[column]; }

private:
  std::map<std::size_t, vtkSmartPointer<vtkStringArray>> arrays_;
};

unsigned long errorCodeOf(winding::FileFault fault)
{
  switch (fault)
  {
  case winding::FileFault::noName:
    return vtkErrorCode::NoFileNameError;
  case winding::FileFault::notFound:
    return vtkErrorCode::FileNotFoundError;
  case winding::FileFault::cannotOpen:
    return vtkErrorCode::CannotOpenFileError;
  case winding::FileFault::ends:
    return vtkErrorCode::PrematureEndOfFileError;
  case winding::FileFault::format:
    break;
  }
  return vtkErrorCode::FileFormatError;
}

} // namespace

vtkWindingNumberReader::vtkWindingNumberReader()
  : Table(std::make_unique<winding::PointTable>())
{
  this->SetNumberOfInputPorts(0);
}

vtkWindingNumberReader::~vtkWindingNumberReader()
{
  this->SetFileName(nullptr);
  this->SetColumns(nullptr);
}

const char* vtkWindingNumberReader::GetFileExtensions()
{
  return winding::suffixesOfMeshes().c_str();
}

std::string vtkWindingNumberReader::GetHeader() const
{
  return this->Table->header;
}

std::string vtkWindingNumberReader::GetRow(vtkIdType point) const
{
  const auto row = static_cast<std::size_t>(point); // negative ones become large
  return row < this->Table->rows.size() ? std::string(this->Table->rows[row]) : std::string();
}

char vtkWindingNumberReader::GetSeparator() const
{
  return this->Table->separator;
}

bool vtkWindingNumberReader::GetHasDecimalCommas() const
{
  return this->Table->hasDecimalCommas;
}

int vtkWindingNumberReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  // The library of the filters knows which ranks there are.
  winding::setRanksOnHost(vtkWindingNumberAlgorithm::GetRanksOnHost());
  this->ErrorCode = vtkErrorCode::NoError;
  *this->Table = {};
  this->ColumnNames->Initialize();
  vtkPolyData* const output = vtkPolyData::GetData(outputs);
  const auto read = [&]()
  {
    try
    {
      winding::SmpExecutor executor(this, 0);
      const winding::InputFile file(this->FileName, [&executor](const winding::InputFile& packed)
        { return winding::unpackGzip(packed, executor); });
      this->Read(file, executor, output);
    }
    catch (const winding::FileRefusal& refusal)
    {
      this->ErrorCode = errorCodeOf(refusal.fault());
      throw;
    }
  };
  const std::string name = this->FileName ? this->FileName : "";
  const std::string withoutMemory = name + ": there is not enough memory for what it holds";
  const winding::Outcome outcome =
    winding::reportErrors(this, this->NamesInMessages, withoutMemory, read);
  if (outcome == winding::Outcome::done)
  {
    return 1;
  }
  if (this->ErrorCode == vtkErrorCode::NoError)
  {
    this->ErrorCode = winding::errorCodeOf(outcome);
  }
  output->Initialize();
  return 0;
}

void vtkWindingNumberReader::Read(
  const winding::InputFile& file, winding::Executor& executor, vtkPolyData* output)
{
  const winding::MeshFormat& format = winding::formatOf(file);
  if (!format.read)
  {
    this->ReadTable(file, format.separator, executor, output);
    return;
  }
  winding::MeshArrays mesh =
    format.read(file, {this->ChosenColumns(), this->ReadAllColumns}, executor);
  for (const winding::Message& note : mesh.notes)
  {
    vtkWarningMacro(<< file.name() << ": " << winding::lineOf(note));
  }
  winding::handOver(mesh, output);
}

void vtkWindingNumberReader::ReadTable(
  const winding::InputFile& file, char separator, winding::Executor& executor, vtkPolyData* output)
{
  winding::TableOptions options;
  options.separator = separator;
  options.columns = this->ChosenColumns();
  options.normalsAndAreas = this->ReadNormalsAndAreas;
  options.rows = this->KeepRows;
  StringArrays texts;
  options.texts = this->ReadAllColumns ? &texts : nullptr;
  winding::PointTable table = winding::readPointTable(file, options, executor);
  for (std::size_t i = 0; i < table.columns.size(); ++i)
  {
    winding::TableColumn& column = table.columns[i];
    vtkSmartPointer<vtkAbstractArray> array = texts.of(i);
    if (!column.isText)
    {
      array = winding::handedArray<vtkDoubleArray>(column.numbers, 1);
    }
    array->SetName(column.name.c_str());
    output->GetPointData()->AddArray(array);
  }
  winding::handOver(table.points, output);
  for (const std::string& name : table.names)
  {
    this->ColumnNames->InsertNextValue(name);
  }
  *this->Table = std::move(table);
}

winding::ColumnChoice vtkWindingNumberReader::ChosenColumns() const
{
  const std::string text = this->Columns ? this->Columns : "";
  return text.empty() ? winding::ColumnChoice() : winding::ColumnChoice(text);
}

void vtkWindingNumberReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NamesInMessages: " << this->NamesInMessages << "\n";
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Columns: " << (this->Columns ? this->Columns : "(none)") << "\n";
  os << indent << "ReadNormalsAndAreas: " << this->ReadNormalsAndAreas << "\n";
  os << indent << "ReadAllColumns: " << this->ReadAllColumns << "\n";
  os << indent << "KeepRows: " << this->KeepRows << "\n";
}
