// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/UninitializedVector.h"
#include "farfield/FarFieldAccuracy.h"
#include "farfield/FarFieldSources.h"
#include "farfield/NodeAcceptance.h"
#include "source/SourceTree.h"

namespace winding
{

/**
 * The moments of all nodes of a tree over sources, with what is needed to accept them. A node's
 * centre is the centroid of its items' area; its radius reaches all of their points.
 *
 * Moments are computed from the items in leaves and from the children elsewhere. Their bits are the
 * same for any executor.
 */
struct SourceMoments
{
  /// The sources must stand in the tree's order. Throws Interrupted when the executor was
  /// interrupted.
  SourceMoments(const SourceTree& tree, const FarFieldSources& sources,
    const FarFieldAccuracy& accuracy, Executor& executor);

  const float* of(std::size_t node) const { return &moments[node * stride]; }

  std::vector<Eigen::Vector3d> centers;
  NodeCriteria criteria; ///< centres relative to `origin`
  std::size_t stride;
  UninitializedVector<float> moments; ///< `stride` numbers of each node, scaled by its radius
  Eigen::Vector3d origin;             ///< the root's centre
};

} // namespace winding
