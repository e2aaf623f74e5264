// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "cloud/NeighborGraph.h"

#include <Eigen/Core>

#include <vector>

namespace winding
{

/// How the normals of points that have none are estimated.
enum class NormalEstimation
{
  /// The spanning tree where its check (CloudOrientation.h) finds it right, else
  /// automaticNormals().
  automatic,
  spanningTree, ///< planes and orientations that are handed on: estimateNormals()
  consistent,   ///< planes and orientations that the field agrees with: ConsistentNormals.h
  toward        ///< planes that look toward viewpoints (Viewpoints.h), which only reports name
};

const char* nameOf(NormalEstimation estimation);

/**
 * Estimates unit normals for points that have none. They are oriented consistently where the points
 * are dense enough, but not yet outward.
 *
 * A point's normal is the direction in which it and its nearest neighbours spread least.
 * Orientations are handed on from neighbour to neighbour, along a tree over the graph of
 * neighbours: from one to the next with a similar normal (Hoppe et al., Surface reconstruction from
 * unorganized points, 1992) that lies across both normals, not along them. Each piece of the graph
 * starts at its highest point, whose normal is turned up, as is right for a solid. Thin parts and
 * sharp edges can fool this; CloudOrientation.h says how much. (vtkPCANormalEstimation keeps the
 * first normal that it finds as it is, follows neighbours in any order, and takes quadratic time
 * where one point is far from all others.) Among the vertices of meshes, 0 to 1 in 2000 normals of
 * scans are wrong, and 1 in 10 of a thousand vertices of a bunny and of a teapot.
 *
 * neighbors is the number of nearest points that are looked at, at least 3. Points at one place
 * have one normal. All normals are finite and of unit length. Points on a line get any normals
 * across it, points at one place any normals. The work takes O(n log n) time, in part on the
 * executor's threads, and the bits are the same for any executor and any order of the
 * points. Throws Interrupted.
 */
std::vector<Eigen::Vector3d> estimateNormals(
  const DistinctPoints& places, int neighbors, Executor& executor);

/// Orients the normals of places along the graph, as estimateNormals() does, on one thread.
/// Throws Interrupted.
void orientByTree(const DistinctPoints& places, const NeighborGraph& graph,
  std::vector<Eigen::Vector3d>& normals, Executor& executor);

/// Hands on orientations along the graph, as orientByTree() does, from all places with a clearness
/// of at least `enough`, which keep theirs. A piece without any starts at its clearest place.
void orientFrom(const DistinctPoints& places, const NeighborGraph& graph,
  const std::vector<double>& clearness, double enough, std::vector<Eigen::Vector3d>& normals,
  Executor& executor);

} // namespace winding
