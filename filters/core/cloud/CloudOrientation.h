// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "source/PointCloud.h"

#include <algorithm>
#include <cmath>

namespace winding
{

/**
 * The testimony of the field itself about the normals of a cloud: winding numbers a little behind
 * its points, against their normals, and a little before them. They are 1 and 0 for a closed cloud,
 * 0 and −1 for one whose normals all point inward, and anything where normals contradict each other
 * or at the borders of an open cloud.
 */
struct CloudOrientation
{
  double behind = 0; ///< median of w behind the points
  double before = 0; ///< median of w before the points
  /// The share of points with w about 1 behind and 0 before them, and that with 0 and −1.
  double outward = 0, inward = 0;

  /// The orientation of the cloud with all normals turned round.
  CloudOrientation reversed() const { return {-before, -behind, inward, outward}; }

  bool isInward() const { return inward > outward; }

  /// Whether most normals point inward.
  bool isMostlyInward() const { return inward > 0.5; }

  /// Whether the points are an open sheet: w is about ½ behind and −½ before them.
  bool isOfSheet() const
  {
    constexpr double about = 0.25;
    return std::abs(behind - 0.5) < about && std::abs(before + 0.5) < about;
  }

  /// Whether the field separates inside from outside nearly everywhere. The share of points with
  /// the field that they should have is 0.95 to 1 among the vertices of scans with right normals,
  /// and 0.82 for a coarse bunny and a teapot, where one estimated normal in ten is wrong.
  bool isClear() const { return std::max(outward, inward) >= clearShare; }

  /// Whether it does so nearly everywhere, but some parts look inward and others outward.
  bool isInwardInPart() const { return !this->isClear() && outward + inward >= clearShare; }

  static constexpr double clearShare = 0.85;
};

/**
 * Evaluates the field plus `added` at two spacings (square roots of the area) behind and before two
 * thousand points at most, evenly chosen by their areas. The cloud needs normals and areas; nothing
 * is found where all areas are 0. It takes a fraction of the time of a field of the cloud, and the
 * result is the same for any executor and any order of the points. Throws Interrupted.
 */
CloudOrientation orientationOf(const PointCloud& cloud, Executor& executor, double added = 0);

} // namespace winding
