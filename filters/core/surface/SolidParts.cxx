// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/SolidParts.h"

#include "source/CompareCoordinates.h"
#include "source/SourceVolume.h"
#include "surface/ClosedComponents.h"
#include "surface/SurfaceEdges.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

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

/// Rounds a volume to four digits, so that copies of a solid are equal wherever they are.
double rounded(double volume)
{
  constexpr double steps = 8192;
  int exponent;
  const double mantissa = std::frexp(volume, &exponent);
  return std::ldexp(std::round(steps * mantissa), exponent);
}

/// The measures that decide on the number of a solid.
struct Rank
{
  std::int32_t component = 0;
  double volume = 0;
  std::int32_t lowest = -1; ///< vertex; -1 of a component without triangles of its own
};

} // namespace

SolidParts solidPartsOf(const Surface& surface, const PolygonParts& parts, Executor& executor)
{
  const Components components = componentsOf(surface, edgesOf(surface, executor), parts);
  const std::vector<std::int32_t> solids = solidsOfComponents(surface, components, executor);

  std::vector<Rank> ranks(components.size());
  const auto& vertices = surface.vertices;
  std::vector<std::int32_t> solidOf;
  solidOf.reserve(surface.triangles.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    solidOf.push_back(solids[components.ofTriangle[i]]);
    Rank& rank = ranks[solidOf.back()];
    for (const std::int32_t v : surface.triangles[i])
    {
      const bool isLower =
        rank.lowest < 0 || compareCoordinates(vertices[v], vertices[rank.lowest]) < 0;
      rank.lowest = isLower ? v : rank.lowest;
    }
  }
  const std::vector<double> volumes = volumesOf(surface, solidOf, components.size());
  for (std::size_t i = 0; i < ranks.size(); ++i)
  {
    ranks[i].component = static_cast<std::int32_t>(i);
    ranks[i].volume = rounded(volumes[i]);
  }
  const auto isNone = [](const Rank& rank)
  {
    return rank.lowest < 0;
  };
  ranks.erase(std::remove_if(ranks.begin(), ranks.end(), isNone), ranks.end());
  std::stable_sort(ranks.begin(), ranks.end(),
    [&vertices](const Rank& a, const Rank& b)
    {
      return a.volume != b.volume ? a.volume > b.volume
                                  : compareCoordinates(vertices[a.lowest], vertices[b.lowest]) < 0;
    });

  std::vector<std::int32_t> numbers(components.size(), -1);
  for (std::size_t i = 0; i < ranks.size(); ++i)
  {
    numbers[ranks[i].component] = static_cast<std::int32_t>(i);
  }
  SolidParts result;
  result.count = ranks.size();
  result.ofTriangle = std::move(solidOf);
  for (std::int32_t& solid : result.ofTriangle)
  {
    solid = numbers[solid];
  }
  return result;
}

} // namespace winding
