// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/InputFile.h"

#include <cstddef>
#include <map>
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
  areas,   ///< area
  /// vp_x, vp_y and vp_z, or Viewpoints:0 and so on: where each point was seen from. Users choose
  /// them as vx, vy and vz, which are velocities in most files.
  viewpoints
};

/**
 * The columns that a user has chosen, as "x=Easting y=Northing z=Height (m) nx=4 ny=5 nz=6 area=7"
 * or "vx=8 vy=9 vz=10": names, or numbers from 1 on where no column has that name. Others go by
 * usual names.
 */
class ColumnChoice
{
public:
  ColumnChoice() = default;

  /// Blanks, commas or semicolons stand before each choice but the first. Throws Refusal for a text
  /// that is none.
  explicit ColumnChoice(const std::string& text);

  bool empty() const { return names_.empty(); }

  /// Whether the positions are chosen by numbers alone, so that a file may have no names.
  bool needsNoNames() const;

  /// The column chosen for a component, as "nx"; null where none is.
  const std::string* of(const std::string& component) const;

  /// Throws FileRefusal where one of the columns is none of `names`, or of a vector some component
  /// is missing.
  void check(const InputFile& file, const std::vector<std::string>& names) const;

private:
  std::map<std::string, std::string> names_; ///< of columns, by components
};

/// The numbers of points that are to be read.
struct ColumnWishes
{
  ColumnChoice chosen;
  bool others = false; ///< whether numbers without a meaning are wanted, too
};

/// The columns that are these, one for each component; none where one of them is missing. Names may
/// have small letters or large ones, and a unit in brackets behind them. Those with colons are the
/// ones that ParaView gives to components; where a table has both, they count. Of several columns
/// with one name the first does.
std::vector<std::size_t> columnsOf(
  ColumnMeaning meaning, const std::vector<std::string>& names, const ColumnChoice& choice = {});

/// Names for `count` columns that have none: Column 1, Column 2 and so on.
std::vector<std::string> numberedColumns(std::size_t count);

/// Names for the arrays of these columns, all different, and none of them taken: the columns' own
/// where that is possible. A column without a name is called Column and its number, from 1
/// on, and one whose name another array has gets its number behind it.
std::vector<std::string> namesOfArrays(const std::vector<std::size_t>& columns,
  const std::vector<std::string>& names, std::set<std::string> taken);

} // namespace winding
