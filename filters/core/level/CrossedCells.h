// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level/LevelEdges.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

namespace winding
{

/**
 * The numbers of the twelve edges of a cell, in the order of VTK's hexahedra and marching cubes:
 * along x, y, x, y in the lower layer, the same in the upper one, and four along z. The numbers of
 * edges that are not crossed mean nothing.
 */
using CellEdges = std::array<std::size_t, 12>;

/// The crossed edges along an axis that begin in a row, as one walks along it.
class LineOfEdges
{
public:
  LineOfEdges(const LevelEdges& edges, int axis, int j, int k)
    : edges_(&edges)
    , reach_(axis == 0 ? 0 : 1)
  {
    std::tie(next_, end_) = edges.inRow(axis, j, k);
    this->look();
  }

  /// First cell from `cell` on that has an edge of the line; `none` if there is none.
  int firstCell(int cell, int none) const
  {
    return next_ == end_ ? none : std::max(cell, nextSample_ - reach_);
  }

  bool isAt(int i) const { return nextSample_ == i; }

  /// Numbers of the edges at i and at i + 1, where there are these.
  std::pair<std::size_t, std::size_t> at(int i) const { return {next_, next_ + this->isAt(i)}; }

  /// Leaves the one at i behind, if there is one. True if there is.
  bool pass(int i)
  {
    const bool isThere = this->isAt(i);
    next_ += isThere;
    this->look();
    return isThere;
  }

private:
  void look()
  {
    nextSample_ = next_ == end_ ? std::numeric_limits<int>::max() : (*edges_)[next_].sample[0];
  }

  const LevelEdges* edges_;
  int reach_; ///< cells before its own that an edge belongs to
  std::size_t next_, end_;
  int nextSample_;
};

/**
 * Visits the cells between the rows (j, k), (j + 1, k), (j, k + 1) and (j + 1, k + 1) that have
 * crossed edges, from `firstCell` to before `endOfCells`; cells without are stepped over. Calls
 * visit(i, inside, edges): bit n of `inside` says whether corner n of the cell is inside, in the
 * order of VTK's hexahedra.
 */
template <class Visit>
void forCrossedCells(
  const LevelEdges& edges, int j, int k, int firstCell, int endOfCells, const Visit& visit)
{
  // Four along x, then two along y and two along z.
  LineOfEdges lines[8] = {{edges, 0, j, k}, {edges, 0, j + 1, k}, {edges, 0, j, k + 1},
    {edges, 0, j + 1, k + 1}, {edges, 1, j, k}, {edges, 1, j, k + 1}, {edges, 2, j, k},
    {edges, 2, j + 1, k}};
  // Whether the samples at i of the four rows are inside.
  int inside[4] = {edges.beginsInside(j, k), edges.beginsInside(j + 1, k),
    edges.beginsInside(j, k + 1), edges.beginsInside(j + 1, k + 1)};
  for (int i = firstCell;; ++i)
  {
    int next = endOfCells;
    for (const LineOfEdges& line : lines)
    {
      next = std::min(next, line.firstCell(i, endOfCells));
    }
    i = next;
    if (i >= endOfCells)
    {
      break;
    }
    const auto y0 = lines[4].at(i), y1 = lines[5].at(i);
    const auto z0 = lines[6].at(i), z1 = lines[7].at(i);
    const CellEdges ofCell = {lines[0].at(i).first, y0.second, lines[1].at(i).first, y0.first,
      lines[2].at(i).first, y1.second, lines[3].at(i).first, y1.first, z0.first, z0.second,
      z1.first, z1.second};
    int index = inside[0] | inside[1] << 3 | inside[2] << 4 | inside[3] << 7;
    for (int row = 0; row < 4; ++row)
    {
      inside[row] ^= lines[row].pass(i);
    }
    index |= inside[0] << 1 | inside[1] << 2 | inside[2] << 5 | inside[3] << 6;
    for (int line = 4; line < 8; ++line)
    {
      lines[line].pass(i);
    }
    visit(i, index, ofCell);
  }
}

} // namespace winding
