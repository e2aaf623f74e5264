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

/// The columns that have these meanings, of x, y, z, nx, ny, nz and area; none where one of them is
/// missing. Names may have small letters or large ones, or be ParaView's for components of points
/// and normals ("Points:0", "Normals:2"). Of several columns with one meaning the first counts.
std::vector<std::size_t> columnsOf(
  const std::vector<std::string>& meanings, const std::vector<std::string>& names);

/// Names for the arrays of these columns, all different, and none of them taken: those of the
/// columns where that is possible. A column without a name is called Column and its number, from 1
/// on, and one whose name another array has gets its number behind it.
std::vector<std::string> namesOfArrays(const std::vector<std::size_t>& columns,
  const std::vector<std::string>& names, std::set<std::string> taken);

} // namespace winding
