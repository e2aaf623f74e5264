// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "base/Executor.h"
#include "base/Lazy.h"
#include "base/Views.h"
#include "farfield/FarField.h"
#include "source/Surface.h"

#include <memory>
#include <mutex>

namespace winding
{

/**
 * The far field of triangles for any samples. Large triangles are cut in pieces that suit the
 * distances between the samples, which takes a tree of its own for each set of samples. The last
 * tree is kept; the tree of the whole triangles is kept for good.
 */
class TriangleFarField
{
public:
  /// Keeps references to the vertices and triangles. `accuracy` holds for all evaluations.
  TriangleFarField(const std::vector<Eigen::Vector3d>& vertices, const ChainView& triangles,
    const Bounds& bounds, const FarFieldAccuracy& accuracy);

  /// Returns the far field that suits the samples, which is never null. It may be called from any
  /// thread; one at a time builds the tree of whole triangles, and one a tree of cut ones. A single
  /// sample has no distance to others, and gets the whole triangles: nothing is locked for these
  /// once their tree is there. Throws Interrupted.
  std::shared_ptr<const FarField> suiting(const Grid& grid, Executor& executor) const;
  std::shared_ptr<const FarField> suiting(const VectorsView& samples, Executor& executor) const;

private:
  std::shared_ptr<const FarField> suiting(
    SplitRule rule, std::size_t samples, Executor& executor) const;
  std::shared_ptr<const FarField> whole(Executor& executor) const;
  std::shared_ptr<const FarField> build(const SplitRule& rule, Executor& executor) const;

  const std::vector<Eigen::Vector3d>& vertices_;
  ChainView triangles_;
  Bounds bounds_;
  FarFieldAccuracy accuracy_;

  mutable std::mutex mutex_;
  Lazy<std::shared_ptr<const FarField>> whole_;
  mutable SplitRule rule_;                       ///< the rule that `last_` was cut by
  mutable std::shared_ptr<const FarField> last_; ///< the last one with cut triangles
};

} // namespace winding
