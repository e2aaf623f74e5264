#include "input/Table.h"

#include "files/FileAccess.h"
#include "files/Suffix.h"
#include "files/TextScanning.h"
#include "input/TableText.h"
#include "program/Failure.h"
#include "program/Threads.h"

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

/// A text in parts of whole rows, which end where lines do unless there are quoted fields: with any
/// of these the whole is one part.
std::vector<std::string_view> partsOf(std::string_view text)
{
  constexpr std::size_t bytesPerPart = 1 << 18;
  const bool hasQuotes = text.find('"') != std::string_view::npos;
  std::vector<std::string_view> parts;
  while (!text.empty())
  {
    const std::size_t end = hasQuotes ? text.size() : text.find('\n', bytesPerPart);
    const std::size_t size = end < text.size() ? end + 1 : text.size();
    parts.push_back(text.substr(0, size));
    text.remove_prefix(size);
  }
  return parts;
}

std::size_t countFields(std::string_view row, char separator)
{
  std::size_t count = 0;
  RowFields fields(row, separator);
  for (std::string_view field; fields.next(field);)
  {
    ++count;
  }
  return count;
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
  // Spreadsheets begin their files with a byte order mark.
  std::size_t start = text_.rfind("\xEF\xBB\xBF", 0) == 0 ? 3 : 0;
  while (start < text_.size() && trimmed(header_).empty())
  {
    const std::string_view rest = std::string_view(text_).substr(start);
    if (!takeRow(text_, separator_, start, header_))
    {
      this->refuseQuotation(rest);
    }
  }
  for (const std::string_view field : splitRow(header_, separator_))
  {
    names_.push_back(unquoted(field));
  }
  this->readRows(std::string_view(text_).substr(std::min(start, text_.size())));
}

std::vector<std::string_view> Table::rowsOf(std::string_view part) const
{
  std::vector<std::string_view> rows;
  for (std::size_t start = 0; start < part.size();)
  {
    const std::string_view rest = part.substr(start);
    std::string_view row;
    if (!takeRow(part, separator_, start, row))
    {
      this->refuseQuotation(rest);
    }
    if (trimmed(row).empty())
    {
      continue;
    }
    if (const std::size_t fields = countFields(row, separator_); fields != names_.size())
    {
      this->refuseRow(row, "has " + std::to_string(fields) + " fields, but the header names " +
                             std::to_string(names_.size()) + "; it is truncated or damaged");
    }
    rows.push_back(row);
  }
  return rows;
}

void Table::readRows(std::string_view text)
{
  const std::vector<std::string_view> parts = partsOf(text);
  std::vector<std::vector<std::string_view>> rows(parts.size());
  runOnThreads(parts.size(), [&](std::size_t i) { rows[i] = this->rowsOf(parts[i]); });
  std::size_t count = 0;
  for (const auto& some : rows)
  {
    count += some.size();
  }
  rows_.reserve(count);
  for (auto& some : rows)
  {
    rows_.insert(rows_.end(), some.begin(), some.end());
    some = {};
  }
}

void Table::refuseQuotation(std::string_view row) const
{
  this->refuseRow(row, "a quotation mark is not closed, or not at the end of its field");
}

void Table::refuseRow(std::string_view row, const std::string& message) const
{
  const auto line = 1 + std::count(text_.data(), row.data(), '\n');
  throw Failure(REFUSED, fileName_, "line " + std::to_string(line) + ": " + message);
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

vtkSmartPointer<vtkDoubleArray> Table::numbers(const std::vector<std::size_t>& columns) const
{
  constexpr std::size_t unwanted = SIZE_MAX, rowsPerBlock = 4096;
  std::vector<std::size_t> places(names_.size(), unwanted); // of each column among the wanted
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    places[columns[i]] = i;
  }
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetNumberOfComponents(static_cast<int>(columns.size()));
  array->SetNumberOfTuples(static_cast<vtkIdType>(rows_.size()));
  double* const values = array->GetPointer(0);
  const auto readRow = [&](std::size_t row)
  {
    RowFields fields(rows_[row], separator_);
    std::string_view field;
    for (std::size_t column = 0; fields.next(field); ++column)
    {
      const std::size_t place = places[column];
      if (place != unwanted && !parseNumber(trimmed(field), values[row * columns.size() + place]))
      {
        this->refuseRow(rows_[row], '"' + std::string(trimmed(field).substr(0, 20)) +
                                      "\" in column " + names_[column] + " is no number");
      }
    }
  };
  runOnThreads((rows_.size() + rowsPerBlock - 1) / rowsPerBlock,
    [&](std::size_t block)
    {
      const std::size_t end = std::min((block + 1) * rowsPerBlock, rows_.size());
      for (std::size_t row = block * rowsPerBlock; row < end; ++row)
      {
        readRow(row);
      }
    });
  return array;
}

std::vector<std::string> Table::texts(std::size_t column) const
{
  std::vector<std::string> texts;
  texts.reserve(rows_.size());
  for (const std::string_view row : rows_)
  {
    texts.push_back(unquoted(splitRow(row, separator_)[column]));
  }
  return texts;
}

bool Table::isNumeric(std::size_t column) const
{
  return std::all_of(rows_.begin(), rows_.end(),
    [&](std::string_view row)
    {
      double value;
      return parseNumber(trimmed(splitRow(row, separator_)[column]), value);
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
  points->SetData(this->numbers(columns));
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
    const auto array = table.numbers(normals);
    array->SetName("Normals");
    cloud->GetPointData()->SetNormals(array);
  }
  if (const std::optional<std::size_t> area = table.findMeaning("area"))
  {
    const auto array = table.numbers({*area});
    array->SetName("Area");
    cloud->GetPointData()->AddArray(array);
  }
  return cloud;
}
