// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/CellPatches.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace winding
{

namespace
{

constexpr std::array<std::array<int, 4>, 6> faces = {
  {{0, 3, 7, 4}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 2, 6, 7}, {0, 1, 2, 3}, {4, 5, 6, 7}}};

constexpr std::array<std::array<int, 2>, 12> ends = {
  {{0, 1}, {1, 2}, {3, 2}, {0, 3}, {4, 5}, {5, 6}, {7, 6}, {4, 7}, {0, 4}, {1, 5}, {3, 7}, {2, 6}}};

bool isInside(int inside, int corner)
{
  return (inside >> corner & 1) != 0;
}

/// The edge between two corners.
int edgeBetween(int a, int b)
{
  const auto joins = [a, b](const std::array<int, 2>& end)
  {
    return (end[0] == a && end[1] == b) || (end[0] == b && end[1] == a);
  };
  return static_cast<int>(std::find_if(ends.begin(), ends.end(), joins) - ends.begin());
}

/// The crossed edges of a face in the pairs that a segment of the surface joins.
std::vector<std::pair<int, int>> segmentsOn(int face, int inside, AmbiguousFaces rule)
{
  const std::array<int, 4>& corners = cornersOfFace(face);
  std::array<int, 4> edges;
  std::vector<int> crossed;
  for (std::size_t n = 0; n < 4; ++n)
  {
    const int from = corners[n], to = corners[(n + 1) % 4];
    edges[n] = edgeBetween(from, to);
    if (isInside(inside, from) != isInside(inside, to))
    {
      crossed.push_back(edges[n]);
    }
  }
  if (crossed.size() < 4)
  {
    return crossed.empty() ? std::vector<std::pair<int, int>>{}
                           : std::vector<std::pair<int, int>>{{crossed[0], crossed[1]}};
  }
  const bool isFirstApart = isInside(inside, corners[0]) == (rule == AmbiguousFaces::insideApart);
  return isFirstApart
           ? std::vector<std::pair<int, int>>{{edges[3], edges[0]}, {edges[1], edges[2]}}
           : std::vector<std::pair<int, int>>{{edges[0], edges[1]}, {edges[2], edges[3]}};
}

CellPatches findPatches(int inside, AmbiguousFaces rule)
{
  CellPatches patches;
  for (std::size_t edge = 0; edge < 12; ++edge)
  {
    const bool isCrossed = isInside(inside, ends[edge][0]) != isInside(inside, ends[edge][1]);
    patches.ofEdge[edge] = isCrossed ? static_cast<signed char>(edge) : -1;
  }
  const auto patchOf = [&patches](int edge) -> signed char&
  {
    return patches.ofEdge[static_cast<std::size_t>(edge)];
  };
  for (int face = 0; face < 6; ++face)
  {
    for (const auto& [a, b] : segmentsOn(face, inside, rule))
    {
      const auto [low, high] = std::minmax(patchOf(a), patchOf(b));
      std::replace(patches.ofEdge.begin(), patches.ofEdge.end(), signed(high), signed(low));
    }
  }
  // Patches are numbered in the order of their first edges.
  for (signed char edge = 0; edge < 12; ++edge)
  {
    if (patchOf(edge) == edge)
    {
      std::replace(patches.ofEdge.begin(), patches.ofEdge.end(), int(edge), 100 + patches.count++);
    }
  }
  for (signed char& patch : patches.ofEdge)
  {
    patch = static_cast<signed char>(patch < 0 ? -1 : patch - 100);
  }
  for (int face = 0; face < 6; ++face)
  {
    const auto segments = segmentsOn(face, inside, rule);
    if (segments.size() == 2 && patchOf(segments[0].first) == patchOf(segments[1].first))
    {
      patches.doubledFace = face;
    }
  }
  return patches;
}

} // namespace

const std::array<int, 4>& cornersOfFace(int face)
{
  return faces[static_cast<std::size_t>(face)];
}

const CellPatches& cellPatches(int inside, AmbiguousFaces rule)
{
  using Table = std::array<std::array<CellPatches, 256>, 2>;
  static const Table table = []
  {
    Table all;
    for (int n = 0; n < 256; ++n)
    {
      const auto at = static_cast<std::size_t>(n);
      all[0][at] = findPatches(n, AmbiguousFaces::insideApart);
      all[1][at] = findPatches(n, AmbiguousFaces::outsideApart);
    }
    return all;
  }();
  return table[rule == AmbiguousFaces::insideApart ? 0 : 1][static_cast<std::size_t>(inside)];
}

} // namespace winding
