#pragma once

#include "base/Executor.h"
#include "source/PointCloud.h"

#include <algorithm>

namespace winding
{

/**
 * What the field itself says about the normals of a cloud: winding numbers a little behind its points,
 * against their normals, and a little before them. Of a closed cloud they are 1 and 0; of one whose
 * normals all point inward 0 and −1; where normals contradict each other, or at the borders of an open
 * cloud, anything.
 */
struct CloudOrientation
{
  double behind = 0; ///< the median
  double before = 0; ///< the median
  /// The share of points with about 1 behind and 0 before them, and with 0 and −1.
  double outward = 0, inward = 0;

  /// Of the cloud with all normals turned round.
  CloudOrientation reversed() const { return {-before, -behind, inward, outward}; }

  bool isInward() const { return inward > outward; }

  /// Whether the field tells inside from outside nearly everywhere. Of the
  /// vertices of scans with right normals 0.95 to 1 of the points have the field that they should have,
  /// of a coarse bunny and a teapot, where one estimated normal in ten is wrong, 0.82.
  bool isClear() const { return std::max(outward, inward) >= clearShare; }

  static constexpr double clearShare = 0.85;
};

/**
 * Looks at two thousand points at most, evenly chosen by their areas, from two spacings (the square
 * root of the area) away. The cloud needs normals and areas; nothing is found where all areas are 0. In
 * time a fraction of what a field of the cloud takes; the same for any executor. Throws Interrupted.
 */
CloudOrientation orientationOf(const PointCloud& cloud, Executor& executor);

} // namespace winding
