// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace winding
{

/**
 * Refuses cells that contradict themselves, before code follows them into memory that is not
 * theirs. All functions throw Refusal, one line with the name of the data and the cell's number.
 */
class CellChecks
{
public:
  /// `name` is the data's, as in "the source", and `points` the number of its points.
  CellChecks(std::string name, std::int64_t points)
    : name_(std::move(name))
    , points_(points)
  {
  }

  /// Refuses the data for a fault such as "has cells whose offsets lead out of their list of ids".
  [[noreturn]] void refuse(const std::string& fault) const;
  [[noreturn]] void refuseCell(std::int64_t cell, const std::string& fault) const;

  /// Refuses offsets of cells that lead out of their list of ids.
  void checkOffsets(bool areValid) const;

  /// Refuses fewer types than there are cells.
  void checkTypes(std::int64_t cells, std::int64_t types) const;

  /// Refuses ids of points that do not exist.
  template <class Ids> void checkIds(std::int64_t cell, Ids first, Ids last) const
  {
    const Ids bad =
      std::find_if(first, last, [this](std::int64_t id) { return id < 0 || id >= points_; });
    if (bad != last)
    {
      this->refuseCell(
        cell, "refers to point " + std::to_string(*bad) + " of " + std::to_string(points_));
    }
  }

  /// Refuses types that VTK does not know, and numbers of points that cells of the type cannot
  /// have. `degrees` are those along three axes, or null (canHavePoints()).
  void checkType(std::int64_t cell, int type, std::int64_t points, const double* degrees) const;

  /// Refuses a type as unknown.
  [[noreturn]] void refuseType(std::int64_t cell, int type) const;

  /**
   * Refuses a polyhedron without faces, or with a face at points that are not its own. `faces` has
   * the number of faces, then the number of points and their ids for each. Empty `own` allows all
   * points that exist.
   */
  void checkPolyhedron(
    std::int64_t cell, const std::vector<std::int64_t>& faces, std::vector<std::int64_t> own) const;

private:
  std::string name_;
  std::int64_t points_;
};

} // namespace winding
