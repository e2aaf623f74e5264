#include "vtkPointTableReader.h"

#include "files/TableFile.h"
#include "private/output/HandedArray.h"
#include "private/output/MeshFiles.h"

#include "vtkDoubleArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <map>
#include <utility>

vtkStandardNewMacro(vtkPointTableReader);

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

void handOver(winding::PointTable& table, StringArrays& texts, vtkPolyData* output)
{
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
}

} // namespace

vtkPointTableReader::vtkPointTableReader()
{
  this->SetNumberOfInputPorts(0);
  this->Table = std::make_unique<winding::PointTable>();
}

vtkPointTableReader::~vtkPointTableReader()
{
  this->SetFileName(nullptr);
}

std::string vtkPointTableReader::GetHeader() const
{
  return this->Table->header;
}

std::string vtkPointTableReader::GetRow(vtkIdType point) const
{
  const auto row = static_cast<std::size_t>(point); // negative ones become large
  return row < this->Table->rows.size() ? std::string(this->Table->rows[row]) : std::string();
}

int vtkPointTableReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  *this->Table = {};
  this->ColumnNames->Initialize();
  vtkPolyData* const output = vtkPolyData::GetData(outputs);
  const auto parse = [this, output](const winding::InputFile& file, winding::Executor& executor)
  {
    winding::TableOptions options;
    options.separator = winding::suffixOf(file) == ".tsv" ? '\t' : ',';
    options.normalsAndAreas = this->ReadNormalsAndAreas;
    StringArrays texts;
    options.texts = this->ReadAllColumns ? &texts : nullptr;
    options.rows = this->KeepRows;
    winding::PointTable table = winding::readPointTable(file, options, executor);
    handOver(table, texts, output);
    for (const std::string& name : table.names)
    {
      this->ColumnNames->InsertNextValue(name);
    }
    *this->Table = std::move(table);
  };
  return winding::readFile(this, this->FileName, this->ErrorCode, parse, output);
}

void vtkPointTableReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "ReadNormalsAndAreas: " << this->ReadNormalsAndAreas << "\n";
  os << indent << "ReadAllColumns: " << this->ReadAllColumns << "\n";
  os << indent << "KeepRows: " << this->KeepRows << "\n";
}
