// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "distance/DistanceTree.h"

namespace winding
{

/// A point of a source, in scaled coordinates.
struct SourcePoint
{
  Eigen::Vector3d position;
  double rounding;    ///< how far from the source rounding may have put it
  std::uint32_t item; ///< number of the item that it lies on
};

/// A box of samples in scaled coordinates, and the source's point nearest to its centre.
struct NearestCell
{
  Eigen::Vector3d low, high;
  SourcePoint nearest;
  double squaredReach; ///< at least the square of the distance of `nearest` from any sample

  Eigen::Vector3d center() const { return low + 0.5 * (high - low); }
  bool isOnePlace() const { return low == high; }

  /// Sets squaredReach, which the box and the nearest point give.
  void setReach()
  {
    squaredReach = (low - nearest.position).squaredNorm() + (high - nearest.position).squaredNorm();
  }
};

/// The cell of a box. The source's nearest point is still to be found.
inline NearestCell cellOf(const Bounds& box)
{
  return {box.min(), box.max(), {Eigen::Vector3d::Zero(), 0, 0}, 0};
}

/**
 * The rounding of distances that are compared to find what may be nearest to a cell's samples.
 *
 * Let x be the point of the source nearest to the cell's centre. Rounding turns it into a point x'
 * within δ of the source (roundingOfOffset, and the rounding of its coordinates). So the source is
 * no farther from a sample q than |q − x'| + δ. A node or an item is dropped only where it is
 * farther than that from all q, and by ε more, the rounding of all distances that are compared. δ
 * and ε are relative to the whole source, not to the cell, which may lie near a vertex and be as
 * small.
 */
class NearestRounding
{
public:
  explicit NearestRounding(const DistanceTree& tree);

  /// Sets cell.nearest to what was found nearest to its centre, and the reach.
  void setNearest(NearestCell& cell, const Nearest& nearest) const;

  /// The sum δ + ε.
  double of(const NearestCell& cell) const;

  /// The most that it may add to a difference of squared distances.
  double slackOf(const NearestCell& cell) const;

  /// Error bound of a thin triangle's squared distance.
  double squareOfThin() const { return squareOfThin_; }

private:
  double sourceSize_ = 0; ///< no distance of two points of the source is larger
  double farthest_ = 0;   ///< no coordinate of the source is larger
  double squareOfThin_ = 0;
};

} // namespace winding
