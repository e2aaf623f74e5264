// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "source/Grid.h"
#include "source/PointCloud.h"
#include "source/Surface.h"

namespace winding
{

/**
 * @file
 * The voxels that a surface or the points of a cloud touch. A voxel is the box of one spacing
 * around its sample, faces, edges and corners included: a point in a face touches both voxels
 * there.
 */

///@{
/**
 * Sets the marks, one per sample of an extent, of the voxels that the triangles or points touch to
 * 1, and leaves the others as they are. Throws Interrupted.
 *
 * Guaranteed: (1) every voxel that is touched is marked, whatever the rounding; (2) every voxel
 * that is marked is touched, or missed by less than 16 ε of the coordinates' size; (3) marks depend
 * on the grid as a whole, not on the extent, the executor or its threads.
 *
 * A triangle is cut along the layers and then along the rows of the grid, and its part between two
 * rows covers one run of voxels: so its time is linear in the rows that it reaches and of the
 * voxels that it marks, however large or thin it is, never in its bounding box. Memory: 24 bytes
 * per vertex, 8 per primitive, and 4 per primitive and layer that it reaches.
 */
void markTouched(const Surface& surface, const Grid& grid, const Extent& extent,
  unsigned char* marks, Executor& executor);
void markTouched(const PointCloud& cloud, const Grid& grid, const Extent& extent,
  unsigned char* marks, Executor& executor);
///@}

} // namespace winding
