// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "files/ColumnNames.h"
#include "files/InputFile.h"
#include "files/LineBlocks.h"
#include "files/MeshArrays.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace winding
{

/// Keeps the texts of columns whose fields are no numbers: what the fields stand for, without
/// quotation marks around them.
class TextColumns
{
public:
  virtual ~TextColumns() = default;

  /// Makes room for a text of every row in a column, which has this index in PointTable::columns.
  virtual void add(std::size_t column, std::size_t rows) = 0;

  /// Takes a text of a column that was added. Threads give different texts at the same time.
  virtual void set(std::size_t column, std::size_t row, const std::string& text) = 0;
};

/// The way to read a table, and what of it.
struct TableOptions
{
  char separator = ',';         ///< or a tab; another one counts where this gives no positions
  ColumnChoice columns;         ///< of the user; a table needs no header where they are numbers
  bool normalsAndAreas = true;  ///< whether these columns are read apart, or are like all others
  bool rows = false;            ///< whether the texts of the rows are kept
  TextColumns* texts = nullptr; ///< null where columns that have no meaning are not wanted
  std::size_t bytesPerBlock = LineBlocks::usualBytes;
};

/// A column of a table that has no meaning. Where a field is no number it is one of texts, which
/// TextColumns has.
struct TableColumn
{
  std::string name;
  bool isText = false;
  PlainArray<double> numbers; ///< empty where it is one of texts
};

/// The content of a table of points.
struct PointTable
{
  MeshArrays points;                ///< with normals and areas where there are these columns
  char separator = ',';             ///< a comma, a tab or a semicolon
  bool hasDecimalCommas = false;    ///< whether commas are the decimal points of any numbers
  std::string header;               ///< the text of the first row, and the end of its last line
  std::vector<std::string> names;   ///< of all columns, as the header has them
  std::vector<TableColumn> columns; ///< those that have no meaning, if they are wanted

  PlainArray<char> text;              ///< the file's, set where rows are; empty if none is kept
  std::vector<std::string_view> rows; ///< parts of it without the ends of their last lines
};

/**
 * Reads points from a table with a header row (.csv, .tsv): one point for each row, from the
 * columns x, y and z, normals from nx, ny and nz, areas from area, where there are any, or from
 * columns that the user has chosen. columnsOf() says which names mean these, and namesOfArrays()
 * gives the other columns theirs; normals and areas, "Normals" and "Area", are taken. Fields may be
 * in quotation marks, as RFC 4180 has it, blank lines are passed over, and so are a byte order
 * mark, slashes before the first name and a number of points on a line of its own behind the names.
 * Empty fields of positions, normals and areas are NaN. All points are in one vertex cell.
 *
 * Throws FileRefusal for a table without x, y and z, for rows with more or fewer fields than the
 * header, for fields that are no numbers in columns that have to be, and for quotation marks that
 * are not closed; and Interrupted. The result is the same for any number of threads and any size of
 * blocks.
 */
PointTable readPointTable(const InputFile& file, const TableOptions& options, Executor& executor);

} // namespace winding
