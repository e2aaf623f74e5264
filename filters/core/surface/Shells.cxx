// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/Shells.h"

#include "base/Pi.h"
#include "surface/UsesByAngle.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace winding
{

namespace
{

/// Returns a side of a triangle: the one that faces the triangles that come next around an edge, by
/// angles that grow, or the one that faces those before. `sense` is a sense of SurfaceEdges::Use.
std::int32_t sideOf(std::int32_t triangle, std::int32_t sense, bool facesNext)
{
  const bool isFront = (sense > 0) == facesNext;
  return 2 * triangle + (isFront ? 0 : 1);
}

} // namespace

Shells::Shells(const Surface& surface, const SurfaceEdges& edges)
  : sets_(2 * surface.triangles.size())
{
  std::vector<std::int32_t> unclearSides;
  for (const SurfaceEdges::Rim& rim : edges.rims)
  {
    sets_.unite(2 * rim.triangle, 2 * rim.triangle + 1);
    unclearSides.push_back(2 * rim.triangle);
  }
  for (const SurfaceEdges::Pair& pair : edges.pairs)
  {
    // Fronts see fronts where the triangles agree.
    const std::int32_t front = 2 * pair.triangles[0], other = 2 * pair.triangles[1];
    sets_.unite(front, other + (pair.agrees ? 0 : 1));
    sets_.unite(front + 1, other + (pair.agrees ? 1 : 0));
  }
  for (const SurfaceEdges::Crowd& crowd : edges.crowds)
  {
    this->joinAround(surface, edges, crowd, unclearSides);
  }
  this->measure(surface, unclearSides);
}

/// Unites the sides that face each other around an edge. Notes sides where the order is not clear.
void Shells::joinAround(const Surface& surface, const SurfaceEdges& edges,
  const SurfaceEdges::Crowd& crowd, std::vector<std::int32_t>& unclearSides)
{
  const std::vector<AngledUse> uses = usesByAngle(surface, edges, crowd);
  for (std::size_t i = 0; i < uses.size(); ++i)
  {
    const bool isLast = i + 1 == uses.size();
    const AngledUse &here = uses[i], &next = uses[isLast ? 0 : i + 1];
    const std::int32_t side = sideOf(here.use.triangle, here.use.sense, true);
    const std::int32_t facing = sideOf(next.use.triangle, next.use.sense, false);
    sets_.unite(side, facing);
    const double between = next.angle - here.angle + (isLast ? 2 * pi : 0);
    if (!here.hasDirection || !next.hasDirection || between < leastAngle)
    {
      unclearSides.insert(unclearSides.end(), {side, side ^ 1, facing ^ 1});
    }
  }
}

/// Finds the shells round bounded regions: the volumes within are negative seen from there.
void Shells::measure(const Surface& surface, const std::vector<std::int32_t>& unclearSides)
{
  const std::size_t sides = 2 * surface.triangles.size();
  shells_.resize(sides);
  std::vector<double> volumes(sides, 0), sizes(sides, 0);
  for (std::size_t side = 0; side < sides; ++side)
  {
    const std::int32_t shell = sets_.find(static_cast<std::int32_t>(side));
    shells_[side] = shell;
    const Triangle& t = surface.triangles[side / 2];
    const Eigen::Vector3d& origin = surface.vertices[surface.triangles[shell / 2][0]];
    const double volume =
      (surface.vertices[t[0]] - origin)
        .dot((surface.vertices[t[1]] - origin).cross(surface.vertices[t[2]] - origin));
    volumes[shell] += side % 2 == 0 ? volume : -volume;
    sizes[shell] += std::abs(volume);
  }
  constexpr double rounding = 1e-10;
  byVolume_.resize(sides, Region::unclear);
  for (std::size_t shell = 0; shell < sides; ++shell)
  {
    if (std::abs(volumes[shell]) > rounding * sizes[shell])
    {
      byVolume_[shell] = volumes[shell] < 0 ? Region::solid : Region::empty;
    }
  }
  for (const std::int32_t side : unclearSides)
  {
    byVolume_[shells_[side]] = Region::unclear;
  }
}

std::vector<Shells::Region> Shells::regions(const std::vector<std::int32_t>& counts) const
{
  struct Wall
  {
    std::int32_t from, to, count;
  };
  std::vector<Wall> walls;
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    const std::int32_t front = shells_[2 * i], back = shells_[2 * i + 1];
    walls.push_back({front, back, counts[i]});
    walls.push_back({back, front, counts[i]});
  }
  std::sort(walls.begin(), walls.end(),
    [](const Wall& a, const Wall& b)
    { return std::tie(a.from, a.to, a.count) < std::tie(b.from, b.to, b.count); });
  walls.erase(std::unique(walls.begin(), walls.end(),
                [](const Wall& a, const Wall& b)
                { return a.from == b.from && a.to == b.to && a.count == b.count; }),
    walls.end());
  constexpr std::int32_t unknown = -1;
  std::vector<std::int32_t> numbers(shells_.size(), unknown);
  DisjointSets reached(shells_.size());
  std::vector<std::int32_t> contradictions, queue;
  for (const std::int32_t shell : shells_)
  {
    if (byVolume_[shell] == Region::empty && numbers[shell] == unknown)
    {
      numbers[shell] = 0;
      queue.push_back(shell);
    }
  }
  for (std::size_t next = 0; next < queue.size(); ++next)
  {
    const std::int32_t from = queue[next];
    const auto first = std::lower_bound(walls.begin(), walls.end(), from,
      [](const Wall& wall, std::int32_t shell) { return wall.from < shell; });
    for (auto wall = first; wall != walls.end() && wall->from == from; ++wall)
    {
      if (byVolume_[wall->to] == Region::unclear)
      {
        continue;
      }
      reached.unite(from, wall->to);
      const std::int32_t number = wall->count - numbers[from];
      if (numbers[wall->to] == unknown && number >= 0)
      {
        numbers[wall->to] = number;
        queue.push_back(wall->to);
      }
      else if (numbers[wall->to] != number)
      {
        contradictions.push_back(from);
      }
    }
  }
  std::vector<char> isUnclear(shells_.size(), 0);
  for (const std::int32_t shell : contradictions)
  {
    isUnclear[reached.find(shell)] = 1;
  }
  std::vector<Region> result;
  result.reserve(shells_.size());
  for (const std::int32_t shell : shells_)
  {
    result.push_back(numbers[shell] == unknown || isUnclear[reached.find(shell)] ? Region::unclear
                     : numbers[shell] == 0                                       ? Region::empty
                                                                                 : Region::solid);
  }
  return result;
}

} // namespace winding
