// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "distance/NearestCell.h"

#include <cmath>
#include <limits>

namespace winding
{

namespace
{

/// A triangle whose sides stand for its inside (NearestKernels.h) is thinner than this times the
/// source: the others have weights that are right to as much.
constexpr double thin = 0x1p-40;

} // namespace

NearestRounding::NearestRounding(const DistanceTree& tree)
{
  if (!tree.empty())
  {
    const Bounds& box = tree.box(0);
    sourceSize_ = box.sizes().norm();
    farthest_ = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
    squareOfThin_ = (thin * sourceSize_) * (thin * sourceSize_);
  }
}

void NearestRounding::setNearest(NearestCell& cell, const Nearest& nearest) const
{
  cell.nearest.position = cell.center() - Eigen::Map<const Eigen::Vector3d>(nearest.offset);
  // Three coordinates are rounded by half an epsilon each.
  cell.nearest.rounding = roundingOfOffset(std::sqrt(nearest.squared), sourceSize_) +
                          std::numeric_limits<double>::epsilon() * farthest_;
  cell.nearest.item = nearest.item;
  cell.setReach();
}

double NearestRounding::of(const NearestCell& cell) const
{
  // Four distances are rounded: from the nearest item and from another one, each from a sample
  // and from a corner of the cell. Items that count as equally near (NearestNumbers.h) are up to
  // two roundings farther than the nearest one, and one more is for that sum.
  return cell.nearest.rounding + 7 * roundingOfOffset(std::sqrt(cell.squaredReach), sourceSize_);
}

double NearestRounding::slackOf(const NearestCell& cell) const
{
  const double rounding = this->of(cell);
  return (2 * std::sqrt(cell.squaredReach) + rounding) * rounding +
         32 * std::numeric_limits<double>::epsilon() * cell.squaredReach + squareOfThin_;
}

} // namespace winding
