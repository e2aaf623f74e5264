#pragma once

#include "Executor.h"
#include "Sanitize.h"

namespace winding
{

/**
 * One area for every point: about the mean area that a point of the cloud stands for.
 *
 * A disk of radius d_j, the distance to the j-th nearest neighbour, holds about j points, so
 * π Σd_j²/Σj over j = 1 … k estimates the area of one (all of them, because on regular grids many
 * neighbours are equally far, and d_k alone is wrong by a quarter); the mean over the cloud, without
 * the largest hundredth (far outliers), is returned. Right within a few percent for evenly sampled
 * surfaces; for uneven ones no single area is. Equal points share the area of one. 0 where the cloud has one point or coincides in one.
 *
 * neighbors is k, at least 1, and is cut off at the number of other points. O(n log n), most of
 * it on the executor's threads; the same bits for any of them. Throws Interrupted.
 */
double meanPointArea(const PointCloud& cloud, Executor& executor, int neighbors = 20);

} // namespace winding
