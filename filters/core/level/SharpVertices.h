// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "level/DualMesh.h"
#include "level/EdgeRoots.h"
#include "level/QuadSplit.h"

#include <vector>

namespace winding
{

/**
 * The places of the vertices of a dual mesh, where the planes through the crossings of their
 * patches meet (FeatureVertex.h): edges and corners of the surface stay sharp. Without roots they
 * are the middles of their cells, which are the corners of voxels around the samples.
 *
 * The plane of a crossing is perpendicular to the normal of its root; in the border of the grid, to
 * the edge. A crossing without a normal has no plane.
 *
 * Guaranteed: vertices lie in their cells, no nearer to other cells than 2⁻¹² of the cell; the bits
 * are the same for every executor.
 *
 * Memory: 24 bytes for each vertex.
 */
class SharpVertices
{
public:
  /// Keeps references, and `roots`, which may be null. Throws Interrupted.
  SharpVertices(const Grid& grid, const LevelEdges& edges, const EdgeRoots* roots,
    const DualMesh& mesh, Executor& executor);

  /// The vertices in units of the grid, as Grid::inGridUnits() has them.
  const std::vector<Eigen::Vector3d>& places() const { return places_; }

  /// The crossing of an edge with the surface, in units of the grid. It keeps the distance of the
  /// vertices from the samples. There are roots.
  Eigen::Vector3d crossing(std::size_t edge) const { return roots_->place(edges_[edge], edge); }

  /// How to cut the quad of an edge that has one; along the first diagonal without roots.
  QuadSplit splitOf(std::size_t edge) const;

private:
  Eigen::Vector3d placeIn(const DualMesh::Patch& patch) const;

  const LevelEdges& edges_;
  const EdgeRoots* roots_; ///< null for middles of cells
  const DualMesh& mesh_;
  Eigen::Vector3d size_; ///< of a cell, in units of the largest spacing
  std::vector<Eigen::Vector3d> places_;
};

} // namespace winding
