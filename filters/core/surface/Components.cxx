// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/Components.h"

#include "base/DisjointSets.h"
#include "source/UnitScale.h"
#include "surface/UsesByAngle.h"

#include <algorithm>
#include <utility>

namespace winding
{

namespace
{

/// Returns, by the representative of each set of triangles, whether an edge of it does not cancel
/// within the set.
std::vector<char> openSets(const SurfaceEdges& edges, DisjointSets& sets, std::size_t triangles)
{
  std::vector<char> isOpen(triangles, 0);
  for (const SurfaceEdges::Rim& rim : edges.rims)
  {
    isOpen[sets.find(rim.triangle)] = 1;
  }
  for (const SurfaceEdges::Pair& pair : edges.pairs)
  {
    if (!pair.agrees)
    {
      isOpen[sets.find(pair.triangles[0])] = 1;
    }
  }
  for (const SurfaceEdges::Crowd& crowd : edges.crowds)
  {
    edges.forEachSet(crowd, sets,
      [&](std::int32_t set, std::int32_t net) { isOpen[set] |= static_cast<char>(net != 0); });
  }
  return isOpen;
}

/// Joins the two triangles of each solid around an edge, whose backs face each other. Of equal
/// angles the triangle comes first whose solid lies before it. Returns whether that works, as it
/// does where no solids overlap.
bool joinSolidsAround(std::vector<AngledUse>& uses, DisjointSets& sets)
{
  for (auto first = uses.begin(), last = first; first != uses.end(); first = last)
  {
    for (++last; last != uses.end() && last->angle - (last - 1)->angle < leastAngle; ++last)
    {
    }
    std::stable_partition(first, last, [](const AngledUse& use) { return use.facesNext(); });
  }
  for (std::size_t i = 0; i < uses.size(); ++i)
  {
    const AngledUse &use = uses[i], &next = uses[(i + 1) % uses.size()];
    if (!use.hasDirection || use.facesNext() == next.facesNext())
    {
      return false;
    }
    if (!use.facesNext())
    {
      sets.unite(use.use.triangle, next.use.triangle);
    }
  }
  return true;
}

/// Divides what was joined at edges of more than two triangles into solids that touch there, where
/// that gives closed ones only. `pieces` are the sets before, `isOpen` says which of them are open,
/// and `joined` are the sets after.
void partTouchingSolids(const Surface& surface, const SurfaceEdges& edges, DisjointSets& pieces,
  const std::vector<char>& isOpen, DisjointSets& joined)
{
  const std::size_t triangles = surface.triangles.size();
  std::vector<char> isKept = openSets(edges, joined, triangles); // by set of `joined`
  DisjointSets solids = pieces;
  for (const SurfaceEdges::Crowd& crowd : edges.crowds)
  {
    std::vector<AngledUse> uses = usesByAngle(surface, edges, crowd);
    const auto isClosed = [&](const AngledUse& use)
    {
      return !isOpen[pieces.find(use.use.triangle)];
    };
    uses.erase(std::remove_if(uses.begin(), uses.end(), isClosed), uses.end());
    if (!uses.empty() && !joinSolidsAround(uses, solids))
    {
      isKept[joined.find(uses[0].use.triangle)] = 1;
    }
  }
  const std::vector<char> isSolidOpen = openSets(edges, solids, triangles);
  for (std::size_t i = 0; i < triangles; ++i)
  {
    const auto triangle = static_cast<std::int32_t>(i);
    isKept[joined.find(triangle)] |= isSolidOpen[solids.find(triangle)];
  }
  DisjointSets parted(triangles);
  for (std::size_t i = 0; i < triangles; ++i)
  {
    const auto triangle = static_cast<std::int32_t>(i);
    const std::int32_t whole = joined.find(triangle);
    parted.unite(triangle, isKept[whole] ? whole : solids.find(triangle));
  }
  joined = std::move(parted);
}

} // namespace

Components componentsOf(
  const Surface& surface, const SurfaceEdges& edges, const PolygonParts& parts)
{
  const std::size_t triangles = surface.triangles.size();
  DisjointSets pieces(triangles);
  for (const SurfaceEdges::Pair& pair : edges.pairs)
  {
    pieces.unite(pair.triangles[0], pair.triangles[1]);
  }
  for (std::size_t i = 1; i < parts.size(); ++i)
  {
    if (parts[i])
    {
      pieces.unite(static_cast<std::int32_t>(i - 1), static_cast<std::int32_t>(i));
    }
  }
  const std::vector<char> isOpen = openSets(edges, pieces, triangles);
  DisjointSets sets = pieces;
  bool isAnyJoined = false;
  for (const SurfaceEdges::Crowd& crowd : edges.crowds)
  {
    std::int32_t first = -1;
    for (const SurfaceEdges::Use* use = edges.begin(crowd); use != edges.end(crowd); ++use)
    {
      if (isOpen[pieces.find(use->triangle)])
      {
        first = first < 0 ? use->triangle : first;
        isAnyJoined |= sets.unite(first, use->triangle);
      }
    }
  }
  if (isAnyJoined)
  {
    partTouchingSolids(surface, edges, pieces, isOpen, sets);
  }

  const std::vector<char> isOpenInTheEnd = openSets(edges, sets, triangles);
  Components components;
  components.ofTriangle.resize(triangles);
  for (std::size_t i = 0; i < triangles; ++i)
  {
    const auto triangle = static_cast<std::int32_t>(i);
    const std::int32_t first = sets.find(triangle);
    if (first == triangle)
    {
      components.ofTriangle[i] = static_cast<std::int32_t>(components.size());
      components.isClosed.push_back(!isOpenInTheEnd[triangle]);
    }
    else
    {
      components.ofTriangle[i] = components.ofTriangle[first]; // `first` is less than i
    }
  }
  return components;
}

double areaOf(const Surface& surface, const Triangle& triangle, double scale)
{
  const Eigen::Vector3d& a = surface.vertices[triangle[0]];
  const Eigen::Vector3d u = (surface.vertices[triangle[1]] - a) * scale;
  const Eigen::Vector3d v = (surface.vertices[triangle[2]] - a) * scale;
  return u.cross(v).norm();
}

void addMiddles(Surface& surface, Components& components, const std::vector<char>& isChosen,
  std::size_t triangles)
{
  const double scale = unitScale(surface.bounds);
  constexpr std::size_t enough = 4096;
  std::vector<std::size_t> counts(components.size(), 0), passed(components.size(), 0);
  for (std::size_t i = 0; i < triangles; ++i)
  {
    ++counts[components.ofTriangle[i]];
  }
  for (std::size_t i = 0; i < triangles; ++i)
  {
    const std::int32_t component = components.ofTriangle[i];
    const std::size_t step = 1 + counts[component] / enough;
    if (isChosen[component] && passed[component]++ % step == 0)
    {
      const Triangle& t = surface.triangles[i];
      const Eigen::Vector3d& a = surface.vertices[t[0]];
      const Eigen::Vector3d offsets =
        (surface.vertices[t[1]] - a) / 3 + (surface.vertices[t[2]] - a) / 3;
      surface.vertices.emplace_back(a + offsets);
      components.middles.push_back({component, areaOf(surface, t, scale)});
    }
  }
}

} // namespace winding
