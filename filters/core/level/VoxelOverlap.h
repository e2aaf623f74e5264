#pragma once

#include "base/Executor.h"
#include "field/Field.h"

namespace winding
{

/**
 * Makes inside, which says of each sample of an extent whether it is inside, say so of each voxel
 * that overlaps the solid or its surface: adds those that triangles or points touch
 * (TouchedVoxels.h), and, where w changes beside the surface, those of which a corner is inside.
 *
 * The field of a closed surface is one value throughout a voxel that no triangle touches, so its
 * sample tells all. That of an open surface or a cloud reaches the threshold between triangles or
 * points, too; where it does, a voxel's corners tell, unless the solid comes into it between them only.
 *
 * Guaranteed: (1) what is inside stays so; (2) what of the triangles and usable points lies in the grid
 * lies in voxels that are inside; (3) the same bits for any extent, executor and number of threads.
 * Memory: that of markTouched(), and a byte per sample where corners are asked. Throws Interrupted.
 */
void addOverlap(const Field& field, const Grid& grid, const Extent& extent, InsideRule rule,
  double threshold, unsigned char* inside, Executor& executor);

/// What that is expected to take for so many samples, beside their field.
EvaluationCost costOfOverlap(const Field& field, std::size_t samples);

} // namespace winding
