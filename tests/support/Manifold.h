// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace shapes
{

/// The faults of polygons as the surface of a solid.
struct ManifoldFaults
{
  std::size_t edges = 0; ///< directed edges that are not there once in each direction
  std::size_t fans = 0;  ///< vertices whose polygons are not one fan around them

  bool any() const { return edges + fans > 0; }
};

/// Polygons, each as its vertices around it.
using Polygons = std::vector<std::vector<std::uint32_t>>;

/// Counts the faults of polygons that are to be a closed, oriented 2-manifold.
inline ManifoldFaults manifoldFaults(const Polygons& polygons)
{
  // A corner of a polygon: the vertex, the one before it and the one behind it.
  std::vector<std::array<std::uint32_t, 3>> corners;
  for (const std::vector<std::uint32_t>& polygon : polygons)
  {
    for (std::size_t n = 0; n < polygon.size(); ++n)
    {
      corners.push_back({polygon[n], polygon[(n + polygon.size() - 1) % polygon.size()],
        polygon[(n + 1) % polygon.size()]});
    }
  }
  std::sort(corners.begin(), corners.end());
  ManifoldFaults faults;
  for (auto first = corners.begin(); first != corners.end();)
  {
    const auto last = std::find_if(
      first, corners.end(), [first](const auto& corner) { return corner[0] != (*first)[0]; });
    // Each neighbour is before the vertex once and behind it once, and from one polygon to the next
    // all are reached.
    const auto degree = static_cast<std::size_t>(last - first);
    std::size_t steps = 0;
    auto at = first;
    do
    {
      const std::uint32_t next = (*at)[2];
      const auto isNext = [next](const auto& corner)
      {
        return corner[1] == next;
      };
      const auto found = std::find_if(first, last, isNext);
      const bool isOnce = found != last && std::count_if(first, last, isNext) == 1;
      faults.edges += !isOnce;
      at = isOnce ? found : first;
      ++steps;
    } while (at != first && steps < degree);
    faults.fans += steps != degree || at != first;
    first = last;
  }
  return faults;
}

} // namespace shapes
