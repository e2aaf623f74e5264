// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/SolidParts.h"

#include "source/CompareCoordinates.h"
#include "surface/ClosedComponents.h"
#include "surface/SurfaceEdges.h"

#include <algorithm>
#include <numeric>

namespace winding
{

namespace
{

/// The component that stands for the solid of each component.
std::vector<std::int32_t> solidsOfComponents(
  const Surface& surface, const Components& components, Executor& executor)
{
  std::vector<std::int32_t> solids(components.size());
  std::iota(solids.begin(), solids.end(), 0);
  for (const ClosedComponent& closed : closedComponents(surface, components, executor))
  {
    if (closed.sense < 0 && closed.around >= 0)
    {
      solids[closed.component] = closed.around;
    }
  }
  // A wall may lie in a wall, and so on, to a component that lies in none or is oriented outward.
  for (std::int32_t& solid : solids)
  {
    while (solids[solid] != solid)
    {
      solid = solids[solid];
    }
  }
  return solids;
}

/// The measures that decide on the number of a solid.
struct Rank
{
  std::int32_t component = 0;
  std::size_t triangles = 0;
  std::int32_t lowest = -1; ///< vertex
};

} // namespace

SolidParts solidPartsOf(const Surface& surface, const PolygonParts& parts, Executor& executor)
{
  const Components components = componentsOf(surface, edgesOf(surface, executor), parts);
  const std::vector<std::int32_t> solids = solidsOfComponents(surface, components, executor);

  std::vector<Rank> ranks(components.size());
  const auto& vertices = surface.vertices;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    Rank& rank = ranks[solids[components.ofTriangle[i]]];
    ++rank.triangles;
    for (const std::int32_t v : surface.triangles[i])
    {
      const bool isLower =
        rank.lowest < 0 || compareCoordinates(vertices[v], vertices[rank.lowest]) < 0;
      rank.lowest = isLower ? v : rank.lowest;
    }
  }
  for (std::size_t i = 0; i < ranks.size(); ++i)
  {
    ranks[i].component = static_cast<std::int32_t>(i);
  }
  const auto isNone = [](const Rank& rank)
  {
    return rank.triangles == 0;
  };
  ranks.erase(std::remove_if(ranks.begin(), ranks.end(), isNone), ranks.end());
  std::stable_sort(ranks.begin(), ranks.end(),
    [&vertices](const Rank& a, const Rank& b)
    {
      return a.triangles != b.triangles
               ? a.triangles > b.triangles
               : compareCoordinates(vertices[a.lowest], vertices[b.lowest]) < 0;
    });

  std::vector<std::int32_t> numbers(components.size(), -1);
  for (std::size_t i = 0; i < ranks.size(); ++i)
  {
    numbers[ranks[i].component] = static_cast<std::int32_t>(i);
  }
  SolidParts result;
  result.count = ranks.size();
  result.ofTriangle.reserve(surface.triangles.size());
  for (const std::int32_t component : components.ofTriangle)
  {
    result.ofTriangle.push_back(numbers[solids[component]]);
  }
  return result;
}

} // namespace winding
