#pragma once

#include "FarField.h"

#include <memory>
#include <mutex>

namespace winding
{

/**
 * The far field of triangles for whatever samples come: large triangles are cut in pieces that suit
 * the samples' distances, which takes another tree. The last one is kept.
 */
class TriangleFarField
{
public:
  /// Keeps references. accuracy: of all evaluations.
  TriangleFarField(const std::vector<Eigen::Vector3d>& vertices,
    const std::vector<Triangle>& triangles, const Bounds& bounds, const FarFieldAccuracy& accuracy);

  /// Null when the executor was interrupted. From any thread; one at a time builds.
  std::shared_ptr<const FarField> suiting(const Grid& grid, Executor& executor) const;
  std::shared_ptr<const FarField> suiting(const VectorsView& samples, Executor& executor) const;

private:
  std::shared_ptr<const FarField> suiting(SplitRule rule, Executor& executor) const;

  const std::vector<Eigen::Vector3d>& vertices_;
  const std::vector<Triangle>& triangles_;
  Bounds bounds_;
  FarFieldAccuracy accuracy_;

  mutable std::mutex mutex_;
  mutable SplitRule rule_; ///< of the last one
  mutable std::shared_ptr<const FarField> last_;
};

} // namespace winding
