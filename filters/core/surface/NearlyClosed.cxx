// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/NearlyClosed.h"

#include "source/CompareCoordinates.h"
#include "source/UnitScale.h"
#include "surface/BoundaryLoops.h"
#include "surface/Cap.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace winding
{

namespace
{

/// A component and a vertex of it: where components touch, their boundaries stay apart.
using OwnVertex = std::pair<std::int32_t, std::int32_t>;

int senseOf(const Triangle& triangle, std::int32_t low, std::int32_t high)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (triangle[i] == low && triangle[(i + 1) % 3] == high)
    {
      return 1;
    }
  }
  return -1;
}

/// Makes a cap that is the same whichever way the loop runs, except for the sense of its triangles:
/// a component must not be judged by another cap once it is turned round.
TriangleList unsidedCapOf(const BoundaryLoop& loop)
{
  std::vector<std::int32_t> rim(loop.begin(), loop.end());
  std::rotate(rim.begin(), std::min_element(rim.begin(), rim.end()), rim.end());
  const bool isReversed = rim.back() < rim[1];
  if (isReversed)
  {
    std::reverse(rim.begin() + 1, rim.end());
  }
  TriangleList cap = capOf(BoundaryLoop(rim.data(), rim.data() + rim.size()));
  for (Triangle& triangle : cap)
  {
    if (isReversed)
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
  return cap;
}

/// The boundary chains of all open components, each over vertices of its own.
class OwnBoundaries
{
public:
  OwnBoundaries(const Surface& surface, const SurfaceEdges& edges, const Components& components)
    : isLess_{surface.vertices}
  {
    for (const SurfaceEdges::Rim& rim : edges.rims)
    {
      this->add(components.ofTriangle[rim.triangle], rim.low, rim.high,
        senseOf(surface.triangles[rim.triangle], rim.low, rim.high));
    }
    for (const SurfaceEdges::Pair& pair : edges.pairs)
    {
      if (!pair.agrees)
      {
        this->add(components.ofTriangle[pair.triangles[0]], pair.low, pair.high,
          2 * senseOf(surface.triangles[pair.triangles[0]], pair.low, pair.high));
      }
    }
    for (const SurfaceEdges::Crowd& crowd : edges.crowds)
    {
      // All open triangles at a crowd are of one component, and closed components cancel there.
      std::int32_t component = -1, net = 0;
      for (const SurfaceEdges::Use* use = edges.begin(crowd); use != edges.end(crowd); ++use)
      {
        net += use->sense;
        const std::int32_t own = components.ofTriangle[use->triangle];
        component = components.isClosed[own] ? component : own;
      }
      if (net != 0)
      {
        this->add(component, crowd.low, crowd.high, net);
      }
    }
    std::sort(vertices_.begin(), vertices_.end(), isLess_);
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  }

  struct OwnCap
  {
    std::int32_t component;
    TriangleList triangles;
  };

  /// Makes a cap for every loop.
  std::vector<OwnCap> caps() const
  {
    BoundaryEdges chain;
    for (const Edge& edge : edges_)
    {
      const std::int32_t low = this->numberOf({edge.component, edge.low});
      const std::int32_t high = this->numberOf({edge.component, edge.high});
      chain.push_back({edge.net > 0 ? low : high, edge.net > 0 ? high : low, std::abs(edge.net)});
    }
    std::sort(chain.begin(), chain.end(),
      [](const BoundaryEdge& a, const BoundaryEdge& b)
      { return std::minmax(a.from, a.to) < std::minmax(b.from, b.to); });
    SerialExecutor serial;
    const BoundaryLoops loops = boundaryLoops(chain, vertices_.size(), serial);
    std::vector<OwnCap> result;
    result.reserve(loops.size());
    for (std::size_t i = 0; i < loops.size(); ++i)
    {
      TriangleList cap = unsidedCapOf(loops[i]);
      for (Triangle& triangle : cap)
      {
        for (std::int32_t& corner : triangle)
        {
          corner = vertices_[corner].second;
        }
      }
      result.push_back({vertices_[loops[i][0]].first, std::move(cap)});
    }
    return result;
  }

private:
  struct Edge
  {
    std::int32_t component, low, high, net;
  };

  void add(std::int32_t component, std::int32_t low, std::int32_t high, std::int32_t net)
  {
    edges_.push_back({component, low, high, net});
    vertices_.emplace_back(component, low);
    vertices_.emplace_back(component, high);
  }

  std::int32_t numberOf(const OwnVertex& vertex) const
  {
    return static_cast<std::int32_t>(
      std::lower_bound(vertices_.begin(), vertices_.end(), vertex, isLess_) - vertices_.begin());
  }

  /// By coordinates, so that caps do not depend on the order of vertices.
  struct IsLess
  {
    bool operator()(const OwnVertex& a, const OwnVertex& b) const
    {
      return a.first != b.first ? a.first < b.first
                                : compareCoordinates(vertices[a.second], vertices[b.second]) < 0;
    }
    const std::vector<Eigen::Vector3d>& vertices;
  };

  IsLess isLess_;
  std::vector<Edge> edges_;
  std::vector<OwnVertex> vertices_;
};

} // namespace

std::vector<char> capNearlyClosed(
  Surface& surface, const SurfaceEdges& edges, Components& components, double mostOfArea)
{
  const double scale = unitScale(surface.bounds);
  std::vector<double> areas(components.size(), 0), capAreas(components.size(), 0);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    areas[components.ofTriangle[i]] += areaOf(surface, surface.triangles[i], scale);
  }
  const auto caps = OwnBoundaries(surface, edges, components).caps();
  for (const auto& cap : caps)
  {
    for (const Triangle& triangle : cap.triangles)
    {
      capAreas[cap.component] += areaOf(surface, triangle, scale);
    }
  }
  std::vector<char> isCapped(components.size(), 0);
  for (const auto& [component, cap] : caps)
  {
    if (capAreas[component] <= mostOfArea * areas[component])
    {
      surface.triangles.insert(surface.triangles.end(), cap.begin(), cap.end());
      components.ofTriangle.insert(components.ofTriangle.end(), cap.size(), component);
      isCapped[component] = components.isClosed[component] = 1;
    }
  }
  return isCapped;
}

std::vector<JudgedComponent> judgedComponents(const Surface& surface, const SurfaceEdges& edges,
  const Components& components, std::vector<char>& isCapped, Executor& executor)
{
  const auto judge = [&](double mostOfArea)
  {
    Surface capped = surface;
    Components solids = components;
    isCapped = capNearlyClosed(capped, edges, solids, mostOfArea);
    addMiddles(capped, solids, isCapped, surface.triangles.size());
    std::vector<JudgedComponent> result;
    for (const ClosedComponent& closed : closedComponents(capped, solids, executor))
    {
      result.push_back({closed, isCapped[closed.component] != 0, false});
    }
    return result;
  };
  const std::vector<JudgedComponent> tight = judge(mostOfTightlyClosed);
  if (tight.size() == components.size())
  {
    return tight;
  }
  std::vector<JudgedComponent> result = judge(mostOfNearlyClosed);
  auto next = tight.begin(); // tightly closed components come in the same order
  for (JudgedComponent& judged : result)
  {
    if (next != tight.end() && next->lies.component == judged.lies.component)
    {
      const bool isWrongToo = judged.isWrong();
      judged = *next++;
      judged.isUnclear = judged.isWrong() != isWrongToo;
    }
  }
  return result;
}

} // namespace winding
