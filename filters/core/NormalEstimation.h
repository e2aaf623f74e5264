#pragma once

#include "Executor.h"

#include <Eigen/Core>

#include <vector>

namespace winding
{

/**
 * Unit normals for points that have none, oriented consistently where they are dense enough, but not
 * yet outward.
 *
 * A point's normal is the direction in which it and its nearest neighbours spread least. Orientations
 * are handed on from neighbour to neighbour, along the tree over the graph of neighbours that turns
 * least (Hoppe et al., Surface reconstruction from unorganized points, 1992). Each piece of the graph
 * starts at its highest point, whose normal is turned up, as is right for a solid. Thin parts and
 * sharp edges can fool this; CloudOrientation.h has what corrects and what measures it.
 *
 * neighbors is how many of them are looked at, at least 3. Points at one place have one normal. All
 * normals are finite and of unit length; where points lie on a line or at one place, they are any
 * across it. O(n log n) time, in part on the executor's threads; the same bits for any executor.
 * Throws Interrupted.
 */
std::vector<Eigen::Vector3d> estimateNormals(
  const std::vector<Eigen::Vector3d>& positions, int neighbors, Executor& executor);

} // namespace winding
