// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "level/DualMesh.h"
#include "level/SharpVertices.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace winding
{

/**
 * The surface between the inside and the outside samples of a grid, with sharp edges and corners:
 * the quads of a DualMesh, between SharpVertices, which face outward. Without roots it consists of
 * the sides of voxels, which are boxes of one spacing around the samples.
 *
 * A quad begins with a corner of the diagonal that it is to be cut along (QuadSplit.h), so that
 * whoever cuts it into a fan of triangles does so along the better one. Where neither diagonal is
 * good there are four triangles instead, around a vertex of their own on the edge of the grid;
 * these vertices come after all others, in the order of the edges.
 *
 * The result is the same for every executor; every function that takes one throws Interrupted.
 */
class SharpContour
{
public:
  /// Keeps references, and `roots`, which may be null. `areTriangles` says whether to cut all
  /// quads.
  SharpContour(const Grid& grid, const LevelEdges& edges, const EdgeRoots* roots, bool areTriangles,
    Executor& executor);

  std::size_t vertices() const { return mesh_.size() + fans_.size(); }
  std::size_t polygons() const { return starts_.back().polygon; }
  std::size_t corners() const { return starts_.back().corner; } ///< of all polygons

  /// Writes three coordinates for each vertex to `points`. `Real` is float or double.
  template <class Real> void place(Real* points, Executor& executor) const;

  /// Writes the ids of all corners, and where each polygon's begin: `offsets` has one more
  /// entry than there are polygons.
  void writePolygons(std::int64_t* offsets, std::int64_t* ids, Executor& executor) const;

  /// Writes the number of the edge of the grid that each polygon lies around.
  void writeEdges(std::uint32_t* numbers, Executor& executor) const;

  /// Writes three components for each polygon: its unit normal, which points outward, or 0 where it
  /// has no area.
  void writeNormals(float* normals, Executor& executor) const;

private:
  /// The numbers of what comes before a block of edges.
  struct Start
  {
    std::size_t polygon = 0, corner = 0, fan = 0;
  };

  template <class Visit> void forPolygons(std::size_t block, const Visit& visit) const;
  std::size_t blocks() const { return starts_.size() - 1; }
  Eigen::Vector3d placeOf(std::size_t vertex) const;

  const Grid& grid_;
  const LevelEdges& edges_;
  bool areTriangles_;
  DualMesh mesh_;
  SharpVertices vertices_;
  std::vector<QuadSplit> splits_;   ///< by edge
  std::vector<std::uint32_t> fans_; ///< edges with a vertex of their own, ascending
  std::vector<Start> starts_;       ///< by block of edges, and of all
};

} // namespace winding
