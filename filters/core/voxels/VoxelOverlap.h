// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "field/Field.h"

namespace winding
{

/**
 * Extends `inside` from the samples of an extent that are inside to all voxels that overlap the
 * solid or its surface: it adds the voxels that triangles or points touch (TouchedVoxels.h), and,
 * where w changes also off the surface, those that have a corner inside.
 *
 * The field of a closed surface has one value throughout a voxel that no triangle touches, so the
 * voxel's sample decides all. The field of an open surface or a cloud reaches the threshold between
 * triangles or points, too; where it does, a voxel's corners decide, unless the solid comes into
 * the voxel between them only.
 *
 * Guaranteed: (1) voxels that are inside stay so; (2) all parts of triangles and all usable points
 * that lie in the grid lie in voxels that are inside; (3) the bits are the same for any extent,
 * executor and number of threads. Memory: as markTouched() takes, and a byte per sample where
 * corners are asked. Throws Interrupted.
 */
void addOverlap(const Field& field, const Grid& grid, const Extent& extent,
  const InsideTest& isInside, unsigned char* inside, Executor& executor);

/// Returns the memory of addOverlap() for `samples` samples, in addition to their field.
std::size_t bytesOfOverlap(const Field& field, std::size_t samples);

} // namespace winding
