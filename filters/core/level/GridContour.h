// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "level/EdgeRoots.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace winding
{

/// Returns whether single precision would move vertices by more than a ten-thousandth of a voxel.
bool needsDoublePoints(const Grid& grid);

/**
 * The triangles between the inside and the outside samples of a grid, by marching cubes: every edge
 * between an inside sample and an outside one has a vertex. Triangles face outward. The result is
 * the same for every executor; every function that takes one throws Interrupted.
 *
 * Only cells with vertices are looked at. Arrays are the caller's: three coordinates for each
 * vertex, three ids for each triangle.
 *
 * Memory: 12 bytes for each triangle, until takeTriangles().
 */
class GridContour
{
public:
  /// Keeps references. The grid and its border together have two samples or more along each axis.
  GridContour(const Grid& grid, const LevelEdges& edges, Executor& executor);

  std::size_t vertices() const { return edges_.size(); }
  std::size_t triangles() const { return layerStarts_.back(); }

  /// Writes the vertices of all triangles to `ids`, and forgets them. Call it once.
  void takeTriangles(std::int64_t* ids, Executor& executor);

  /// Writes the vertices to `points`, in the order of the edges, at the roots. Vertices keep a
  /// little away from both samples, so that no two coincide. `Real` is float or double.
  template <class Real> void place(const EdgeRoots& roots, Real* points, Executor& executor) const;

  /// Writes unit normals of the vertices at `points` to `normals`. They point outward: the `known`
  /// normals, turned if need be. A vertex whose known normal is 0 gets the mean of the triangles
  /// around it, weighted by area, or 0 where the triangles cancel.
  template <class Real>
  void writeNormals(const std::int64_t* ids, const Real* points,
    const std::vector<Eigen::Vector3f>& known, float* normals, Executor& executor) const;

private:
  template <class Real>
  std::vector<Eigen::Vector3d> areasAround(
    const std::int64_t* ids, const Real* points, Executor& executor) const;

  const Grid& grid_;
  const LevelEdges& edges_;
  std::vector<std::vector<std::uint32_t>> corners_; ///< by layer of cells
  std::vector<std::size_t> layerStarts_; ///< first triangle between each layer and the next
};

} // namespace winding
