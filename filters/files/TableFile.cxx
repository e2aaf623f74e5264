// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/TableFile.h"

#include "base/Progress.h"
#include "files/ColumnNames.h"
#include "files/TableRows.h"
#include "files/Words.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <set>
#include <utility>

namespace winding
{

namespace
{

/// Where the fields of a column go as numbers: the one of the first row, and every n-th place
/// behind it the next one's.
struct Target
{
  double* first = nullptr;
  std::size_t step = 0;   ///< 0 where the column is passed over
  bool mayBeText = false; ///< whether fields may be no numbers
  std::size_t other = 0;  ///< the column's place among the table's others, if they may
};

/// Reads the fields of the rows of a table.
class FieldsParser
{
public:
  FieldsParser(const InputFile& file, const TableRows& rows, PointTable& table)
    : file_(file)
    , rows_(rows)
    , table_(table)
    , targets_(table.names.size())
    , isText_(table.names.size())
  {
  }

  /// Has columns read as the components of one array. Returns whether there are any.
  bool readInto(PlainArray<double>& numbers, const std::vector<std::size_t>& columns)
  {
    numbers = PlainArray<double>(rows_.count() * columns.size());
    for (std::size_t i = 0; i < columns.size(); ++i)
    {
      targets_[columns[i]] = {numbers.begin() + (numbers.empty() ? 0 : i), columns.size()};
    }
    return !columns.empty();
  }

  /// Has all columns read that are not read yet. `taken` are the names of other arrays.
  void readOthers(const std::set<std::string>& taken)
  {
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < targets_.size(); ++i)
    {
      if (targets_[i].step == 0)
      {
        TableColumn& column = table_.columns.emplace_back();
        column.numbers = PlainArray<double>(rows_.count());
        targets_[i] = {column.numbers.data(), 1, true, others.size()};
        others.push_back(i);
      }
    }
    const std::vector<std::string> names = namesOfArrays(others, table_.names, taken);
    for (std::size_t i = 0; i < others.size(); ++i)
    {
      table_.columns[i].name = names[i];
    }
  }

  void keepRows()
  {
    table_.text = PlainArray<char>(file_.size());
    table_.rows.resize(rows_.count());
  }

  /// Texts are null where no others are read.
  void run(TextColumns* texts, Executor& executor)
  {
    Progress progress(executor);
    progress.set(0, texts ? 0.7 : 1);
    rows_.visit([this](TableRows::Part& part) { this->readNumbers(part); }, executor);
    rows_.checkEnd();
    table_.hasDecimalCommas = hasDecimalCommas_;
    if (hasDecimalCommas_ && hasDecimalPoints_)
    {
      file_.refuse(
        "has decimal commas and decimal points: take commas out that separate thousands");
    }
    bool hasTexts = false;
    for (std::size_t i = 0; i < targets_.size(); ++i)
    {
      if (isText_[i])
      {
        TableColumn& column = table_.columns[targets_[i].other];
        column.isText = true;
        column.numbers = {};
        texts->add(targets_[i].other, rows_.count());
        hasTexts = true;
      }
    }
    if (hasTexts)
    {
      progress.set(0.7, 1);
      rows_.visit([&](TableRows::Part& part) { this->readTexts(part, *texts); }, executor);
    }
  }

private:
  void readNumbers(TableRows::Part& part)
  {
    while (part.nextRow())
    {
      RowScanner& fields = part.fields();
      for (std::size_t i = 0; i < targets_.size(); ++i)
      {
        this->readField(part, i);
      }
      if (fields.state() != RowState::ended)
      {
        this->checkFields(part);
      }
      if (!table_.rows.empty())
      {
        char* const text = &table_.text[part.offset()];
        std::copy(fields.row().begin(), fields.row().end(), text);
        table_.rows[part.number()] = {text, fields.row().size()};
      }
    }
    if (part.fields().hasDecimalCommas())
    {
      hasDecimalCommas_ = true;
    }
    if (part.fields().hasDecimalPoints())
    {
      hasDecimalPoints_ = true;
    }
  }

  void readField(TableRows::Part& part, std::size_t index)
  {
    const Target& target = targets_[index];
    const bool isNumber = target.step > 0 && !isText_[index];
    if (isNumber && part.fields().nextNumber(target.first[target.step * part.number()]))
    {
      return;
    }
    std::string_view field;
    if (isNumber || !part.fields().nextField(field))
    {
      this->checkFields(part);
    }
    if (!isNumber)
    {
      return;
    }
    part.fields().nextField(field);
    const std::string_view content = contentOf(field);
    if (target.mayBeText)
    {
      isText_[index] = true;
    }
    else if (content.empty())
    {
      target.first[target.step * part.number()] = std::numeric_limits<double>::quiet_NaN();
    }
    else
    {
      part.refuse(shown(content) + " in column " + table_.names[index] + " is no number; " +
                  (content.find(',') == std::string_view::npos ? "correct it, or leave it empty"
                                                               : "write a decimal point"));
    }
  }

  void readTexts(TableRows::Part& part, TextColumns& texts)
  {
    while (part.nextRow())
    {
      for (std::size_t i = 0; i < targets_.size(); ++i)
      {
        std::string_view field;
        if (!part.fields().nextField(field))
        {
          file_.refuseChanged();
        }
        if (isText_[i])
        {
          texts.set(targets_[i].other, part.number(), unquoted(field));
        }
      }
      if (part.fields().state() != RowState::ended)
      {
        file_.refuseChanged();
      }
    }
  }

  /// Throws FileRefusal where the present row has not as many fields as the header.
  void checkFields(const TableRows::Part& part) const
  {
    if (const std::size_t fields = part.countFields(); fields != targets_.size())
    {
      part.refuse("has " + std::to_string(fields) + (fields == 1 ? " field" : " fields") +
                  ", but the header names " + std::to_string(targets_.size()) +
                  "; give each row a field for every column, and decimal points to numbers");
    }
  }

  const InputFile& file_;
  const TableRows& rows_;
  PointTable& table_;
  std::vector<Target> targets_;           ///< one for each column
  std::vector<std::atomic<bool>> isText_; ///< of each column, whether a field was no number
  std::atomic<bool> hasDecimalCommas_{false}, hasDecimalPoints_{false};
};

/// The words for a table without positions, by the names between its separators.
std::string withoutPositions(const std::vector<std::string>& names, char separator)
{
  const std::string none = "has no columns x, y and z";
  const char* at = names.empty() ? nullptr : names[0].data();
  const std::size_t words = names.size() == 1 ? countWords(at, at + names[0].size()) : 0;
  return none + (words >= 3 ? ", since blanks separate its fields; give it the suffix .xyz"
                            : std::string("; name them in the first line, separated by ") +
                                (separator == '\t' ? "tabs" : "commas"));
}

/// Whether the fields in the columns of positions are numbers, so that a row is no header.
bool holdsNumbers(
  const std::vector<std::string>& fields, const ColumnChoice& columns, char separator)
{
  const std::vector<std::size_t> positions = columnsOf(ColumnMeaning::positions, fields, columns);
  return !positions.empty() &&
         std::all_of(positions.begin(), positions.end(),
           [&](std::size_t column)
           {
             std::string field = fields[column];
             std::replace(field.begin(), field.end(), separator == ',' ? '.' : ',', '.');
             double value;
             return parseNumber(field, value);
           });
}

/// Makes a header for a table that has none, and begins where the header was looked for.
void nameByNumbers(TableHeader& header, char separator)
{
  header.names = numberedColumns(header.names.size());
  header.text.clear();
  for (const std::string& name : header.names)
  {
    header.text += (header.text.empty() ? "" : std::string(1, separator)) + name;
  }
  header.text += '\n';
  header.end = header.start;
}

/// Reads the header with the first separator that gives it positions. Throws FileRefusal where none
/// does.
TableHeader readHeader(const InputFile& file, const TableOptions& options, char& separator)
{
  const bool mayHaveNoNames = options.columns.needsNoNames();
  for (const bool hasNames : {false, true})
  {
    for (const char candidate : {options.separator, ';', ',', '\t'})
    {
      if (!hasNames && !mayHaveNoNames)
      {
        continue;
      }
      separator = candidate;
      try
      {
        TableHeader header = readTableHeader(file, separator, options.bytesPerBlock);
        if (!hasNames && holdsNumbers(header.names, options.columns, separator))
        {
          nameByNumbers(header, separator);
          return header;
        }
        if (hasNames && !columnsOf(ColumnMeaning::positions, header.names, options.columns).empty())
        {
          return header;
        }
      }
      catch (const FileRefusal& refusal)
      {
        if (refusal.fault() != FileFault::format)
        {
          throw; // else a quotation mark may end its field before another separator
        }
      }
    }
  }
  const TableHeader header = readTableHeader(file, options.separator, options.bytesPerBlock);
  options.columns.check(file, header.names);
  file.refuse(withoutPositions(header.names, options.separator));
}

} // namespace

PointTable readPointTable(const InputFile& file, const TableOptions& options, Executor& executor)
{
  PointTable table;
  TableHeader header = readHeader(file, options, table.separator);
  table.header = std::move(header.text);
  table.names = std::move(header.names);
  options.columns.check(file, table.names);
  const auto positions = columnsOf(ColumnMeaning::positions, table.names, options.columns);
  Progress progress(executor);
  progress.set(0, 0.2); // finding the rows takes a fifth of the time
  const TableRows rows(file, table.separator, header.end, options.bytesPerBlock, executor);
  FieldsParser parser(file, rows, table);
  parser.readInto(table.points.points.doubles, positions);
  std::set<std::string> taken;
  if (options.normalsAndAreas)
  {
    if (parser.readInto(table.points.normals.doubles,
          columnsOf(ColumnMeaning::normals, table.names, options.columns)))
    {
      taken.insert("Normals");
    }
    if (parser.readInto(
          table.points.areas, columnsOf(ColumnMeaning::areas, table.names, options.columns)))
    {
      taken.insert("Area");
    }
    if (parser.readInto(table.points.viewpoints,
          columnsOf(ColumnMeaning::viewpoints, table.names, options.columns)))
    {
      taken.insert("Viewpoints");
    }
  }
  if (options.texts)
  {
    parser.readOthers(taken);
  }
  if (options.rows)
  {
    parser.keepRows();
  }
  progress.set(0.2, 1);
  parser.run(options.texts, executor);
  table.points.vertices = oneCellOf(rows.count());
  return table;
}

} // namespace winding
