// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Border.h"
#include "Handles.h"
#include "messages/PropertyChecks.h"
#include "source/Sanitize.h"
#include "surface/Boundary.h"
#include "surface/BoundaryLoops.h"
#include "surface/Cap.h"
#include "surface/Slits.h"
#include "surface/SurfaceEdges.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

using namespace winding::c;
using winding::Surface;
using winding::SurfaceEdges;

namespace
{

/// Collects polygons over the vertices of a surface.
class FaultMesh
{
public:
  FaultMesh(const Surface& surface, winding_mesh& mesh)
    : surface_(surface)
    , mesh_(mesh)
  {
    mesh_.offsets.push_back(0);
  }

  template <class Vertices> void add(const Vertices& vertices, std::size_t number)
  {
    mesh_.corners.insert(mesh_.corners.end(), vertices.begin(), vertices.end());
    mesh_.offsets.push_back(static_cast<std::int64_t>(mesh_.corners.size()));
    mesh_.numbers.push_back(static_cast<std::int64_t>(number));
  }

  /// Adds the width of the polygon that was added last.
  void addWidth(double width) { mesh_.slitWidths.push_back(width); }

  /// Leaves the vertices that polygons use, in their order, and renumbers corners.
  void finish()
  {
    std::vector<std::int64_t> newIds(surface_.vertices.size(), -1);
    for (const std::int64_t corner : mesh_.corners)
    {
      newIds[static_cast<std::size_t>(corner)] = 0;
    }
    std::int64_t next = 0;
    for (std::size_t vertex = 0; vertex < newIds.size(); ++vertex)
    {
      if (newIds[vertex] == 0)
      {
        const Eigen::Vector3d& place = surface_.vertices[vertex];
        mesh_.doublePoints.insert(mesh_.doublePoints.end(), place.begin(), place.end());
        newIds[vertex] = next++;
      }
    }
    for (std::int64_t& corner : mesh_.corners)
    {
      corner = newIds[static_cast<std::size_t>(corner)];
    }
  }

private:
  const Surface& surface_;
  winding_mesh& mesh_;
};

/// Returns how often each loop runs along one of its edges, at most.
std::vector<std::size_t> multiplicitiesOf(
  const winding::BoundaryChain& chain, const winding::BoundaryLoops& loops)
{
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> edges; // the few above 1
  for (const winding::BoundaryEdge& edge : chain.edges)
  {
    if (edge.multiplicity > 1)
    {
      edges[std::minmax(edge.from, edge.to)] = edge.multiplicity;
    }
  }
  std::vector<std::size_t> result(loops.size(), 1);
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    const winding::BoundaryLoop loop = loops[i];
    for (std::size_t n = 0; n < loop.size(); ++n)
    {
      const auto found = edges.find(std::minmax(loop[n], loop[(n + 1) % loop.size()]));
      const std::size_t times = found == edges.end() ? 1 : static_cast<std::size_t>(found->second);
      result[i] = std::max(result[i], times);
    }
  }
  return result;
}

/// Adds the caps of the loops of the boundary.
void addCaps(const Surface& surface, winding::Executor& executor, FaultMesh& mesh)
{
  const winding::BoundaryLoops loops = winding::boundaryLoops(
    winding::boundaryChain(surface, executor).edges, surface.vertices.size(), executor);
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    for (const winding::Triangle& triangle : winding::capOf(loops[i]))
    {
      mesh.add(triangle, i);
    }
  }
}

/// Adds the loops of the boundary, with their widths.
void addBoundary(const Surface& surface, winding::Executor& executor, FaultMesh& mesh)
{
  const winding::BoundaryChain chain = winding::boundaryChain(surface, executor);
  const winding::BoundaryLoops loops =
    winding::boundaryLoops(chain.edges, surface.vertices.size(), executor);
  const std::vector<std::size_t> multiplicities = multiplicitiesOf(chain, loops);
  const SurfaceEdges edges = winding::edgesOf(surface, executor);
  const winding::Slits slits = winding::slitsOf(surface, edges, executor);
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    std::vector<std::int32_t> closed(loops[i].begin(), loops[i].end());
    closed.push_back(closed.front());
    mesh.add(closed, multiplicities[i]);
    mesh.addWidth(winding::widestAlong(loops[i], edges, slits)
                    .value_or(std::numeric_limits<double>::quiet_NaN()));
  }
}

/// Adds edges of more than two triangles, or edges about which two triangles disagree.
void addEdges(const SurfaceEdges& edges, bool areCrowds, FaultMesh& mesh)
{
  using Edge = std::array<std::int32_t, 2>;
  if (areCrowds)
  {
    for (const SurfaceEdges::Crowd& crowd : edges.crowds)
    {
      mesh.add(Edge{crowd.low, crowd.high}, crowd.endOfUses - crowd.firstUse);
    }
    return;
  }
  for (const SurfaceEdges::Pair& pair : edges.pairs)
  {
    if (!pair.agrees)
    {
      mesh.add(Edge{pair.low, pair.high}, 2);
    }
  }
}

} // namespace

winding_status winding_faults(winding_array points, const winding_polygons* polygons, int32_t fault,
  const winding_run* run, winding_mesh** mesh, winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      required(mesh, "mesh") = nullptr;
      if (fault < WINDING_FAULT_BOUNDARY || fault > WINDING_FAULT_INCONSISTENT)
      {
        throw Misuse("fault is no winding_fault");
      }
      const Triangles triangles(points, polygons);
      Call call(run);
      giveHandle(*mesh,
        [&](winding_mesh& made)
        {
          const Surface surface = winding::sanitize(triangles.views(), call.executor);
          FaultMesh faults(surface, made);
          if (fault == WINDING_FAULT_BOUNDARY)
          {
            addBoundary(surface, call.executor, faults);
          }
          else if (fault == WINDING_FAULT_CAPS)
          {
            addCaps(surface, call.executor, faults);
          }
          else
          {
            addEdges(winding::edgesOf(surface, call.executor), fault == WINDING_FAULT_NON_MANIFOLD,
              faults);
          }
          faults.finish();
        });
    });
}
