#pragma once

#include "base/Executor.h"
#include "files/InputFile.h"
#include "files/LineBlocks.h"
#include "files/MeshArrays.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace winding
{

/// The way to read a table, and what of it.
struct TableOptions
{
  char separator = ',';    ///< or a tab
  bool normalsAndAreas = true; ///< whether these columns are read as such, or are like all others
  bool allColumns = false; ///< whether columns that have no meaning are read, too
  bool rowPlaces = false;  ///< whether the places of the rows in the file are wanted
  std::size_t bytesPerBlock = LineBlocks::usualBytes;
};

/// A column of a table. Numbers are filled where all fields are numbers, texts otherwise.
struct TableColumn
{
  std::string name;
  PlainArray<double> numbers;
  std::vector<std::string> texts; ///< without quotation marks around them
};

/// The content of a table of points.
struct PointTable
{
  MeshArrays points;                ///< with normals and areas where there are such columns
  std::string header;               ///< the text of the first row, and the end of its last line
  std::vector<std::string> names;   ///< of all columns, as the header has them
  std::vector<TableColumn> columns; ///< those that have no meaning, if they are wanted

  /// For each point the offset of its row in the file, and its bytes without the end of its last
  /// line; empty if they are not wanted.
  PlainArray<std::int64_t> rowPlaces;
};

/**
 * Reads points from a table with a header row (.csv, .tsv): one point for each row, from the
 * columns x, y and z, normals from nx, ny and nz, areas from area, where there are such. Names may
 * have small letters or large ones, or be ParaView's for components of points and normals
 * ("Points:0", "Normals:2"); of several columns with one meaning the first counts. Fields may be in
 * quotation marks, as RFC 4180 has it, blank lines are passed over, and so is a byte order mark.
 * All points are in one vertex cell.
 *
 * A column without a name that is read because all are wanted is called Column and its number, from
 * 1 on.
 *
 * Throws FileRefusal for a table without x, y and z, for rows with more or fewer fields than the
 * header, for fields that are no numbers in columns that have to be, and for quotation marks that
 * are not closed; and Interrupted. The result is the same for any number of threads and any size of
 * blocks.
 */
PointTable readPointTable(const InputFile& file, const TableOptions& options, Executor& executor);

} // namespace winding
