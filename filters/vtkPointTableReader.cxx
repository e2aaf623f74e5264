#include "vtkPointTableReader.h"

#include "files/TableFile.h"
#include "private/HandedArray.h"
#include "private/MeshFiles.h"

#include "vtkDoubleArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"
#include "vtksys/SystemTools.hxx"

vtkStandardNewMacro(vtkPointTableReader);

namespace
{

vtkSmartPointer<vtkStringArray> textsOf(const std::vector<std::string>& texts)
{
  auto array = vtkSmartPointer<vtkStringArray>::New();
  array->SetNumberOfValues(static_cast<vtkIdType>(texts.size()));
  for (std::size_t i = 0; i < texts.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), texts[i]);
  }
  return array;
}

void handOver(winding::PointTable& table, bool withPlaces, vtkPolyData* output)
{
  for (winding::TableColumn& column : table.columns)
  {
    vtkSmartPointer<vtkAbstractArray> array;
    if (column.texts.empty())
    {
      array = winding::handedArray<vtkDoubleArray>(column.numbers, 1);
    }
    else
    {
      array = textsOf(column.texts);
      column.texts = {};
    }
    array->SetName(column.name.c_str());
    output->GetPointData()->AddArray(array);
  }
  if (withPlaces)
  {
    const auto places = winding::handedArray<vtkTypeInt64Array>(table.rowPlaces, 2);
    places->SetName("RowPlace");
    places->SetComponentName(0, "Offset");
    places->SetComponentName(1, "Size");
    output->GetPointData()->AddArray(places);
  }
  winding::handOver(table.points, output);
}

} // namespace

vtkPointTableReader::vtkPointTableReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkPointTableReader::~vtkPointTableReader()
{
  this->SetFileName(nullptr);
}

int vtkPointTableReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  this->Header.clear();
  this->ColumnNames->Initialize();
  vtkPolyData* const output = vtkPolyData::GetData(outputs);
  const auto parse = [this, output](const winding::InputFile& file, winding::Executor& executor)
  {
    winding::TableOptions options;
    const std::string suffix = vtksys::SystemTools::GetFilenameLastExtension(file.name());
    options.separator = vtksys::SystemTools::LowerCase(suffix) == ".tsv" ? '\t' : ',';
    options.normalsAndAreas = this->ReadNormalsAndAreas;
    options.allColumns = this->ReadAllColumns;
    options.rowPlaces = this->GenerateRowPlaces;
    winding::PointTable table = winding::readPointTable(file, options, executor);
    handOver(table, options.rowPlaces, output);
    for (const std::string& name : table.names)
    {
      this->ColumnNames->InsertNextValue(name);
    }
    this->Header = table.header;
  };
  return winding::readFile(this, this->FileName, this->ErrorCode, parse, output);
}

void vtkPointTableReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "ReadNormalsAndAreas: " << this->ReadNormalsAndAreas << "\n";
  os << indent << "ReadAllColumns: " << this->ReadAllColumns << "\n";
  os << indent << "GenerateRowPlaces: " << this->GenerateRowPlaces << "\n";
}
