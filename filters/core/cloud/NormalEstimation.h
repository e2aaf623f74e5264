#pragma once

#include "base/Executor.h"

#include <Eigen/Core>

#include <vector>

namespace winding
{

/**
 * Unit normals for points that have none, oriented consistently where they are dense enough, but not
 * yet outward.
 *
 * A point's normal is the direction in which it and its nearest neighbours spread least. Orientations
 * are handed on from neighbour to neighbour, along a tree over the graph of neighbours: from one to
 * the next with a similar normal (Hoppe et al., Surface reconstruction from unorganized points, 1992)
 * that lies across both normals, not along them. Each piece of the graph starts at its highest point,
 * whose normal is turned up, as is right for a solid. Thin parts and sharp edges can fool this;
 * CloudOrientation.h tells how much. (vtkPCANormalEstimation turns the first normal it finds as it
 * is, follows neighbours in any order, and takes quadratic time where one point is far from all
 * others.) Wrong, of the vertices of meshes: 0 to 1 in 2000 of scans, 1 in 10 of a thousand vertices
 * of a bunny and of a teapot.
 *
 * neighbors is how many of them are looked at, at least 3. Points at one place have one normal. All
 * normals are finite and of unit length; where points lie on a line or at one place, they are any
 * across it. O(n log n) time, in part on the executor's threads; the same bits for any executor.
 * Throws Interrupted.
 */
std::vector<Eigen::Vector3d> estimateNormals(
  const std::vector<Eigen::Vector3d>& positions, int neighbors, Executor& executor);

} // namespace winding
