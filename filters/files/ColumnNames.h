#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

/**
 * @file
 * The names of a table's columns: what they mean, and what the columns' arrays are called.
 */
namespace winding
{

/// The things of points that columns may be.
enum class ColumnMeaning
{
  /// x, y and z, or Points:0, Points:1 and Points:2; each may also be easting, northing and
  /// elevation, height or altitude
  positions,
  normals, ///< nx, ny and nz, or Normals:0, Normals:1 and Normals:2, or normal_x and so on
  areas    ///< area
};

/// The columns that are these, one for each component; none where one of them is missing. Names may
/// have small letters or large ones, and a unit in brackets behind them. Those with colons are the
/// ones that ParaView gives to components; where a table has both, they count. Of several columns
/// with one name the first does.
std::vector<std::size_t> columnsOf(ColumnMeaning meaning, const std::vector<std::string>& names);

/// Names for the arrays of these columns, all different, and none of them taken: those of the
/// columns where that is possible. A column without a name is called Column and its number, from 1
/// on, and one whose name another array has gets its number behind it.
std::vector<std::string> namesOfArrays(const std::vector<std::size_t>& columns,
  const std::vector<std::string>& names, std::set<std::string> taken);

} // namespace winding
