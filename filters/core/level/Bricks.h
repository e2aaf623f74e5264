// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "source/Grid.h"

namespace winding
{

/**
 * A grid cut into cubes of voxels, whose sides are a power of two. They begin at the grid's first
 * voxel, and the last ones along an axis may reach beyond the grid. Bricks are numbered as samples
 * are: along x first, then y, then z.
 */
struct Bricks
{
  int depth = 0;                                    ///< a side has 2^depth voxels
  Eigen::Vector3i counts = Eigen::Vector3i::Zero(); ///< bricks per axis

  int side() const { return 1 << depth; }
  std::size_t size() const;

  /// The bricks of a grid, as an extent whose samples are bricks.
  Extent whole() const;

  /// The voxels of the grid that lie in an extent of bricks.
  Extent voxelsOf(const Extent& bricks, const Grid& grid) const;

  /// The voxels of the grid that lie in one brick.
  Extent voxelsOf(const Eigen::Vector3i& brick, const Grid& grid) const;
};

/**
 * The bricks that suit a grid: the smallest with at least 16 voxels a side, if there are at
 * most 4096, but none with more than 1024 voxels a side. Trees of larger bricks have fewer vertices
 * in all; smaller bricks need less memory while their trees are made. Throws Refusal for grids of
 * more than a million of the largest bricks.
 */
Bricks bricksOf(const Grid& grid);

} // namespace winding
