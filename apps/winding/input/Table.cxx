#include "input/Table.h"

#include "files/FileAccess.h"
#include "files/Suffix.h"
#include "files/TextScanning.h"
#include "input/TableText.h"
#include "program/Failure.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstdint>
#include <map>

namespace
{

/// A column's name in small letters; x, y and so on for the names that ParaView has.
std::string plainName(const std::string& column)
{
  const std::string name = inSmallLetters(column);
  static const std::map<std::string, std::string> others = {{"points:0", "x"}, {"points:1", "y"},
    {"points:2", "z"}, {"normals:0", "nx"}, {"normals:1", "ny"}, {"normals:2", "nz"}};
  const auto other = others.find(name);
  return other == others.end() ? name : other->second;
}

/// Columns as the components of one array.
vtkSmartPointer<vtkDoubleArray> interleaved(
  const Table& table, const std::vector<std::size_t>& columns)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetNumberOfComponents(static_cast<int>(columns.size()));
  array->SetNumberOfTuples(static_cast<vtkIdType>(table.rows()));
  const std::vector<double> values = table.numbers(columns);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

/// The columns that have these meanings; none where one of them is missing.
std::vector<std::size_t> findAll(const Table& table, const std::vector<std::string>& names)
{
  std::vector<std::size_t> columns;
  for (const std::string& name : names)
  {
    const std::optional<std::size_t> column = table.findMeaning(name);
    if (!column)
    {
      return {};
    }
    columns.push_back(*column);
  }
  return columns;
}

} // namespace

Table::Table(const std::string& fileName)
  : fileName_(fileName)
  , text_(contentsOf(fileName))
  , separator_(suffixOf(fileName) == ".tsv" ? '\t' : ',')
  , lineEnd_(text_.find("\r\n") != std::string::npos ? "\r\n" : "\n")
{
  std::size_t line = 0;
  // Spreadsheets begin their files with a byte order mark.
  std::size_t start = text_.rfind("\xEF\xBB\xBF", 0) == 0 ? 3 : 0;
  while (start < text_.size())
  {
    ++line;
    std::string_view row;
    if (!takeRow(text_, separator_, start, row))
    {
      throw Failure(REFUSED, fileName_,
        "line " + std::to_string(line) +
          ": a quotation mark is not closed, or not at the end of its field");
    }
    const std::size_t first = line;
    line += static_cast<std::size_t>(std::count(row.begin(), row.end(), '\n'));
    if (trimmed(row).empty())
    {
      continue;
    }
    if (names_.empty())
    {
      header_ = row;
      for (const std::string_view field : splitRow(row, separator_))
      {
        names_.push_back(unquoted(field));
      }
      continue;
    }
    std::size_t fields = 0;
    RowFields rest(row, separator_);
    for (std::string_view field; rest.next(field);)
    {
      ++fields;
    }
    if (fields != names_.size())
    {
      throw Failure(REFUSED, fileName_,
        "line " + std::to_string(first) + ": has " + std::to_string(fields) +
          " fields, but the header names " + std::to_string(names_.size()) +
          "; it is truncated or damaged");
    }
    rows_.push_back({row, first});
  }
}

std::optional<std::size_t> Table::find(const std::string& name) const
{
  return this->findIf([&name](const std::string& column) { return column == name; });
}

std::optional<std::size_t> Table::findMeaning(const std::string& name) const
{
  return this->findIf([&name](const std::string& column) { return plainName(column) == name; });
}

std::optional<std::size_t> Table::findIf(
  const std::function<bool(const std::string&)>& isWanted) const
{
  const auto found = std::find_if(names_.begin(), names_.end(), isWanted);
  if (found == names_.end())
  {
    return {};
  }
  return static_cast<std::size_t>(found - names_.begin());
}

std::vector<double> Table::numbers(const std::vector<std::size_t>& columns) const
{
  constexpr std::size_t unwanted = SIZE_MAX;
  std::vector<std::size_t> places(names_.size(), unwanted); // of each column among the wanted
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    places[columns[i]] = i;
  }
  std::vector<double> values(rows_.size() * columns.size());
  for (std::size_t i = 0; i < rows_.size(); ++i)
  {
    RowFields fields(rows_[i].text, separator_);
    std::string_view field;
    for (std::size_t column = 0; fields.next(field); ++column)
    {
      const std::size_t place = places[column];
      if (place != unwanted && !parseNumber(trimmed(field), values[i * columns.size() + place]))
      {
        throw Failure(REFUSED, fileName_,
          "line " + std::to_string(rows_[i].line) + ": \"" +
            std::string(trimmed(field).substr(0, 20)) + "\" in column " + names_[column] +
            " is no number");
      }
    }
  }
  return values;
}

std::vector<std::string> Table::texts(std::size_t column) const
{
  std::vector<std::string> texts;
  texts.reserve(rows_.size());
  for (const Row& row : rows_)
  {
    texts.push_back(unquoted(splitRow(row.text, separator_)[column]));
  }
  return texts;
}

bool Table::isNumeric(std::size_t column) const
{
  return std::all_of(rows_.begin(), rows_.end(),
    [&](const Row& row)
    {
      double value;
      return parseNumber(trimmed(splitRow(row.text, separator_)[column]), value);
    });
}

vtkSmartPointer<vtkPolyData> Table::points() const
{
  const std::vector<std::size_t> columns = findAll(*this, {"x", "y", "z"});
  if (columns.empty())
  {
    throw Failure(REFUSED, fileName_,
      std::string("has no columns x, y and z; name them in the first line, separated by ") +
        (separator_ == ',' ? "commas" : "tabs"));
  }
  vtkNew<vtkPoints> points;
  points->SetData(interleaved(*this, columns));
  vtkNew<vtkCellArray> vertices;
  if (points->GetNumberOfPoints() > 0) // VTK's writers crash on a cell without points
  {
    vertices->InsertNextCell(points->GetNumberOfPoints());
  }
  for (vtkIdType id = 0; id < points->GetNumberOfPoints(); ++id)
  {
    vertices->InsertCellPoint(id);
  }
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  cloud->SetPoints(points);
  cloud->SetVerts(vertices);
  return cloud;
}

vtkSmartPointer<vtkPolyData> cloudFrom(const Table& table)
{
  vtkSmartPointer<vtkPolyData> cloud = table.points();
  const std::vector<std::size_t> normals = findAll(table, {"nx", "ny", "nz"});
  if (!normals.empty())
  {
    const auto array = interleaved(table, normals);
    array->SetName("Normals");
    cloud->GetPointData()->SetNormals(array);
  }
  if (const std::optional<std::size_t> area = table.findMeaning("area"))
  {
    const auto array = interleaved(table, {*area});
    array->SetName("Area");
    cloud->GetPointData()->AddArray(array);
  }
  return cloud;
}
