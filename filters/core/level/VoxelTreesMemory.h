// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "level/VoxelTrees.h"

namespace winding
{

/**
 * The number of vertices that the trees of a grid's voxels are expected to have, leaves and
 * parents.
 *
 * A cube of s³ voxels has different sides where the surface passes between its samples: of E edges
 * of the grid that it crosses (levelEdgesByArea()), E (s − 1)/s³ lie in such cubes, whatever the
 * direction of the surface. Where the grid ends within cubes, these are divided, too. Where w is
 * smooth but not constant, a coarser grid of at most 64 samples along each axis tells how many
 * cubes it varies in by more than the tolerance. Throws Interrupted.
 */
double expectedVertices(
  const Field& field, const Grid& grid, const VoxelTreeOptions& options, Executor& executor);

/// Returns the expected memory of `vertices` vertices in addition to the field: of a
/// vtkHyperTreeGrid, and of what is at work while it is made.
std::size_t bytesOfVoxelTrees(
  const Field& field, const Grid& grid, const VoxelTreeOptions& options, double vertices);

} // namespace winding
