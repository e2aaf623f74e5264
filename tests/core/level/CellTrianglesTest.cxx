// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/CellTriangles.h"

#include "level/CellPatches.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>

namespace
{

using namespace winding;

using Edges = std::map<std::pair<int, int>, int>;

/// Counts how often the triangles of a cell go along each pair of edges, less how often they go
/// back.
Edges boundaryOf(const CellTriangles& cell)
{
  Edges boundary;
  for (int n = 0; n < cell.size; ++n)
  {
    const int first = n - n % 3;
    const int from = cell.edges[static_cast<std::size_t>(n)];
    const int to = cell.edges[static_cast<std::size_t>(first + (n + 1) % 3)];
    ++boundary[{from, to}];
    --boundary[{to, from}];
  }
  for (auto pair = boundary.begin(); pair != boundary.end();)
  {
    pair = pair->second <= 0 ? boundary.erase(pair) : std::next(pair);
  }
  return boundary;
}

TEST(CellTriangles, FillThePatchesOfTheirCells)
{
  for (int inside = 0; inside < 256; ++inside)
  {
    const CellTriangles& cell = cellTriangles()[static_cast<std::size_t>(inside)];
    const CellPatches& patches = cellPatches(inside, AmbiguousFaces::insideApart);
    const Edges boundary = boundaryOf(cell);
    std::set<int> begun, crossed;
    for (const auto& [pair, times] : boundary)
    {
      EXPECT_EQ(times, 1) << inside;
      EXPECT_TRUE(begun.insert(pair.first).second) << inside;
      EXPECT_EQ(patches.ofEdge[static_cast<std::size_t>(pair.first)],
        patches.ofEdge[static_cast<std::size_t>(pair.second)])
        << inside;
    }
    for (int edge = 0; edge < 12; ++edge)
    {
      if (patches.ofEdge[static_cast<std::size_t>(edge)] >= 0)
      {
        crossed.insert(edge);
      }
    }
    // Each crossed edge lies once on its patch's loop. Discs of n corners have n - 2 triangles.
    EXPECT_EQ(begun, crossed) << inside;
    EXPECT_EQ(cell.size / 3, static_cast<int>(crossed.size()) - 2 * patches.count) << inside;
  }
}

TEST(CellTriangles, OfOppositeCellsOfOneCornerFaceOppositeWays)
{
  for (int corner = 0; corner < 8; ++corner)
  {
    const Edges one = boundaryOf(cellTriangles()[std::size_t(1) << corner]);
    for (const auto& [pair, times] : boundaryOf(cellTriangles()[255 - (std::size_t(1) << corner)]))
    {
      EXPECT_EQ(one.count({pair.second, pair.first}), 1u) << corner;
    }
  }
}

} // namespace
