#pragma once

#include "base/Bounds.h"
#include "base/Executor.h"
#include "base/Views.h"
#include "farfield/FarField.h"
#include "source/Surface.h"

#include <atomic>
#include <memory>
#include <mutex>

namespace winding
{

/**
 * The far field of triangles for whatever samples come: large triangles are cut in pieces that suit
 * the samples' distances, which takes another tree. The last one is kept, and that of the triangles as
 * they are for good.
 */
class TriangleFarField
{
public:
  /// Keeps references. accuracy: of all evaluations.
  TriangleFarField(const std::vector<Eigen::Vector3d>& vertices,
    const std::vector<Triangle>& triangles, const Bounds& bounds, const FarFieldAccuracy& accuracy);

  /// Null when the executor was interrupted. From any thread; one at a time builds. A sample alone has
  /// no distance to others, and gets the triangles as they are: nothing is locked for those once there.
  std::shared_ptr<const FarField> suiting(const Grid& grid, Executor& executor) const;
  std::shared_ptr<const FarField> suiting(const VectorsView& samples, Executor& executor) const;

private:
  std::shared_ptr<const FarField> suiting(SplitRule rule, Executor& executor) const;
  std::shared_ptr<const FarField> whole(Executor& executor) const;
  std::shared_ptr<const FarField> build(const SplitRule& rule, Executor& executor) const;

  const std::vector<Eigen::Vector3d>& vertices_;
  const std::vector<Triangle>& triangles_;
  Bounds bounds_;
  FarFieldAccuracy accuracy_;

  mutable std::mutex mutex_;
  mutable std::atomic<bool> hasWhole_{false};
  mutable std::shared_ptr<const FarField> whole_; ///< never changed again once there
  mutable SplitRule rule_;                        ///< of the last one with cut triangles
  mutable std::shared_ptr<const FarField> last_;
};

} // namespace winding
