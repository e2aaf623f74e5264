// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/Openings.h"

#include "base/Digits.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <cmath>

namespace winding
{

namespace
{

/// Returns the sides of the bounds in which openings lie, in words. The edges in a side go round an
/// area there, seen from its middle, that is a twentieth of the surface's or more, and no triangle
/// lies in it.
std::string planesOf(const BoundaryEdges& boundary, const Surface& surface, double area)
{
  const Bounds& bounds = surface.bounds;
  const std::vector<Eigen::Vector3d>& vertices = surface.vertices;
  const double reach = 1e-6 * bounds.sizes().maxCoeff();
  const double scale = unitScale(bounds);
  const Eigen::Vector3d center = bounds.center();
  std::string planes;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double place : {bounds.min()[axis], bounds.max()[axis]})
    {
      const auto isThere = [&](std::int32_t vertex)
      {
        return std::abs(vertices[vertex][axis] - place) <= reach;
      };
      double twice = 0;
      for (const BoundaryEdge& edge : boundary)
      {
        if (isThere(edge.from) && isThere(edge.to))
        {
          const Eigen::Vector3d p = (vertices[edge.from] - center) * scale;
          const Eigen::Vector3d q = (vertices[edge.to] - center) * scale;
          twice += edge.multiplicity * p.cross(q)[axis];
        }
      }
      const bool isOpen = std::abs(twice) >= 0.1 * area &&
                          std::none_of(surface.triangles.begin(), surface.triangles.end(),
                            [&isThere](const Triangle& t)
                            { return isThere(t[0]) && isThere(t[1]) && isThere(t[2]); });
      if (isOpen)
      {
        planes += joined(planes.empty() ? "" : " and ", "xyz"[axis], " = ", place);
      }
    }
  }
  return planes;
}

} // namespace

int sideBehindLids(const BoundaryEdges& boundary, const Surface& surface)
{
  const Bounds& bounds = surface.bounds;
  const std::vector<Eigen::Vector3d>& vertices = surface.vertices;
  constexpr double raggedness = 0.1, leastVolume = 0.03;
  // Sides 2 axis and 2 axis + 1 are the lower and the upper one.
  const auto liesIn = [&](const BoundaryEdge& edge, int side)
  {
    const int axis = side / 2;
    const double reach = raggedness * bounds.sizes()[axis];
    const double place = side % 2 == 0 ? bounds.min()[axis] : bounds.max()[axis];
    return std::abs(vertices[edge.from][axis] - place) <= reach &&
           std::abs(vertices[edge.to][axis] - place) <= reach;
  };
  Eigen::Vector3d origin = bounds.center();
  bool isTaken[3] = {};
  std::vector<const BoundaryEdge*> left;
  for (const BoundaryEdge& edge : boundary)
  {
    left.push_back(&edge);
  }
  while (!left.empty())
  {
    int best = -1;
    std::ptrdiff_t most = 0;
    for (int side = 0; side < 6; ++side)
    {
      const std::ptrdiff_t count = std::count_if(left.begin(), left.end(),
        [&](const BoundaryEdge* edge) { return !isTaken[side / 2] && liesIn(*edge, side); });
      best = count > most ? side : best;
      most = std::max(most, count);
    }
    if (best < 0)
    {
      return 0;
    }
    isTaken[best / 2] = true;
    origin[best / 2] = best % 2 == 0 ? bounds.min()[best / 2] : bounds.max()[best / 2];
    left.erase(std::remove_if(left.begin(), left.end(),
                 [&](const BoundaryEdge* edge) { return liesIn(*edge, best); }),
      left.end());
  }
  const double scale = unitScale(bounds);
  double volume = 0, area = 0;
  for (const Triangle& t : surface.triangles)
  {
    const Eigen::Vector3d a = (vertices[t[0]] - origin) * scale;
    const Eigen::Vector3d b = (vertices[t[1]] - origin) * scale;
    const Eigen::Vector3d c = (vertices[t[2]] - origin) * scale;
    volume += a.dot(b.cross(c)) / 6;
    area += (b - a).cross(c - a).norm() / 2;
  }
  const bool isClear = std::abs(volume) > leastVolume * area * scale * bounds.diagonal().norm();
  return !isClear ? 0 : volume > 0 ? 1 : -1;
}

std::vector<OpenComponent> openComponents(
  const Surface& surface, const Components& components, Executor& executor)
{
  constexpr std::size_t fewest = 4, many = 10'000; // triangles
  std::vector<std::vector<Triangle>> triangles(components.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    const auto component = static_cast<std::size_t>(components.ofTriangle[i]);
    if (!components.isClosed[component])
    {
      triangles[component].push_back(surface.triangles[i]);
    }
  }
  SerialExecutor serial; // threads cost more than what small components need
  constexpr std::int32_t none = -1;
  std::vector<std::int32_t> numbers(surface.vertices.size(), none);
  std::vector<OpenComponent> result;
  for (std::size_t component = 0; component < triangles.size(); ++component)
  {
    if (triangles[component].size() < fewest)
    {
      continue;
    }
    OpenComponent& open = result.emplace_back();
    open.component = static_cast<std::int32_t>(component);
    for (const Triangle& t : triangles[component])
    {
      Triangle& own = open.surface.triangles.emplace_back(t);
      for (std::size_t corner = 0; corner < 3; ++corner)
      {
        std::int32_t& number = numbers[t[corner]];
        if (number == none)
        {
          number = static_cast<std::int32_t>(open.surface.vertices.size());
          open.surface.vertices.push_back(surface.vertices[t[corner]]);
          open.surface.bounds.extend(surface.vertices[t[corner]]);
        }
        own[corner] = number;
      }
    }
    for (const Triangle& t : triangles[component])
    {
      for (const std::int32_t vertex : t)
      {
        numbers[vertex] = none;
      }
    }
    const bool isLarge = open.surface.triangles.size() >= many;
    open.edges = isLarge ? boundaryChain(open.surface, executor).edges
                         : boundaryChain(open.surface, serial).edges;
  }
  return result;
}

Openings openingsOf(const BoundaryEdges& boundary, const Surface& surface, double area)
{
  Openings openings;
  const double scale = unitScale(surface.bounds);
  const double scaledArea = area * scale * scale;
  if (boundary.empty() || !(scaledArea > 0))
  {
    return openings;
  }
  const Eigen::Vector3d center = surface.bounds.center();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const BoundaryEdge& edge : boundary)
  {
    const Eigen::Vector3d p = (surface.vertices[edge.from] - center) * scale;
    const Eigen::Vector3d q = (surface.vertices[edge.to] - center) * scale;
    sum += static_cast<double>(edge.multiplicity) * p.cross(q);
  }
  openings.share = std::min(0.5 * sum.norm() / scaledArea, 1.0);
  constexpr double leastOfSide = 0.2;
  if (openings.share > leastOfSide && !openings.areOfSheet())
  {
    openings.planes = planesOf(boundary, surface, scaledArea);
    openings.lookInward = sideBehindLids(boundary, surface) < 0;
  }
  return openings;
}

Message openSideAdvice(const Openings& openings)
{
  const std::string facts = "openings" + (openings.planes.empty() ? "" : " at " + openings.planes) +
                            " are " + percentOf(openings.share) + " as large as its faces";
  if (openings.lookInward)
  {
    return {"the surface is open on a whole side and looks inward",
      {{"turn its faces", {{Parameter::orientFaces, 1}}}}, facts};
  }
  return {"the surface is open on a whole side",
    {{"close it", {Parameter::flatBase, Parameter::mirror}},
      {"name the side of the sheet", {Parameter::sheetSide}}},
    facts};
}

} // namespace winding
