// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace winding
{

/**
 * A triangle in units of a grid, where sample (i, j, k) is at (i, j, k). It says which rows along
 * x cross it, in which direction, and between which samples. Every decision is exact for the given
 * coordinates (Predicates.h); rounded arithmetic only narrows down where to ask.
 */
class RowTriangle
{
public:
  RowTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

  /// The rows (j, k) of layer k that may cross: j in [first, last], empty if last < first.
  struct Range
  {
    int first, last;
  };
  Range rowsIn(int k, int lowest, int highest) const;

  /// The sign of the crossing of row (j, k), walked along +x: +1 if it leaves through the front of
  /// the triangle, −1 if it enters, 0 if it does not cross.
  int crossingSign(int j, int k) const;

  /// The first sample i in [lowest, highest] behind the crossing of a row that crosses with this
  /// sign; highest + 1 if there is none. Samples before it see the triangle along +x.
  int firstBehind(int j, int k, int sign, int lowest, int highest) const;

  /// The x at which a crossing row crosses, as far as rounding goes, and never beyond the triangle.
  double crossingAt(int j, int k) const;

  /// The triangle's normal, with twice its area as length.
  const Eigen::Vector3d& areaVector() const { return normal_; }

private:
  double crossingX(int j, int k, double& error) const;

  Eigen::Vector3d a_, b_, c_;
  Eigen::Vector3d normal_, normalMagnitude_;
  double lowX_, highX_, lowY_, highY_;
};

} // namespace winding
