// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "source/DistinctPoints.h"

#include <Eigen/Core>

#include <vector>

namespace winding
{

/// Normals of a cloud, and how well they agree with the field that they make.
struct ConsistentNormals
{
  std::vector<Eigen::Vector3d> normals; ///< unit vectors that point outward
  /// The mean square of w − 1/2 at points of the cloud, where w is the field of points spread over
  /// a spacing each: about 0.01 where normals are right, 0.1 and more where many are not. That of
  /// noisy clouds may be of some of their points, and up to a factor of their areas; it is of
  /// normals before they are found again.
  double deviation = 0;
  bool triedPatches = false; ///< false where the normals of the spanning tree fit well
};

/**
 * Estimates unit normals for points that have none, and orients them by the winding number itself:
 * w is 1/2 at every point of a closed surface, and 1 or 0 where normals contradict each other.
 *
 * Directions come from planes through neighbours. Patches in which directions agree beyond doubt
 * (NormalPatches.h) are turned as a whole, such that w is about 1/2 at points of the cloud
 * (PatchSigns.h). Other points follow their neighbours. Then every point is turned such that w
 * decreases along its normal, as winding-number normal consistency asks for (Lin, Shi, Liu, Fast
 * and Globally Consistent Normal Orientation based on the Winding Number Normal Consistency, 2024).
 * Several sizes of neighbourhoods and several bounds of doubt are tried, and the spanning tree of
 * NormalEstimation.h among them; the result is the one with the least deviation. Where senses are
 * known, so are the two sheets of thin parts, and directions are taken again, from planes through
 * neighbours on one sheet only (sheetNormals()). The sides of noisy clouds are found by some of
 * their places; where that fits badly, sheets that noise makes nearly touch are separated
 * (NoisySheets.h), and planes through more neighbours are tried. Then w of all places turns single
 * normals of noisy clouds, before their directions are taken again.
 *
 * neighbors: the most neighbours that planes go through, at least 3. byTree: the normals that
 * estimateNormals() gives for the same points and neighbours, in either sense as a whole, where
 * they are known already. Points at one place have one normal. All normals are finite. The bits are
 * the same for any executor and any order of the points. The work takes O(n log n) time and about
 * 350 bytes per point in addition to the points. Throws Interrupted.
 */
ConsistentNormals consistentNormals(const DistinctPoints& places, int neighbors, Executor& executor,
  std::vector<Eigen::Vector3d> byTree = {});

/// Finds which normals of a cloud are to be turned round, where their directions are right but
/// their senses may not be: 1 for those. It is found by the same patches, and none is turned where
/// w is about 1/2 already. `positions` and `normals`, of any length: as many. Points that are not
/// finite, or have no direction, are left alone. Throws Interrupted.
std::vector<unsigned char> normalsToTurn(const std::vector<Eigen::Vector3d>& positions,
  const std::vector<Eigen::Vector3d>& normals, Executor& executor);

} // namespace winding
