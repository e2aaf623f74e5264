// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "farfield/FarFieldAccuracy.h"
#include "farfield/FarFieldSources.h"
#include "farfield/SourceMoments.h"
#include "source/SourceTree.h"

#include <memory>
#include <vector>

namespace winding
{

/**
 * Sources in a tree, with the moments of its nodes: all that cells of samples look at on the way
 * from the whole of the samples down to the leaves (FarFieldTraversal.h). It is built once, then
 * immutable.
 */
struct FarFieldTree
{
  /// Throws Interrupted when the executor was interrupted.
  FarFieldTree(std::unique_ptr<FarFieldSources> sourcesToArrange, const FarFieldAccuracy& wanted,
    Executor& executor);

  double scale() const { return sources->scale(); }
  int order() const { return accuracy.order; }
  const std::vector<SourceNode>& nodes() const { return hierarchy.nodes(); }
  bool empty() const { return hierarchy.nodes().empty(); }

  /// The offset from the root's centre to a sample in the caller's coordinates, in units of the
  /// root's radius.
  Eigen::Vector3d offsetFromRoot(const Eigen::Vector3d& sample) const;

  std::unique_ptr<FarFieldSources> sources; ///< in the order of the hierarchy
  FarFieldAccuracy accuracy;
  SourceTree hierarchy;
  SourceMoments moments;
  std::vector<float> toPolynomial; ///< matrix from local expansions to polynomials, by columns
};

} // namespace winding
