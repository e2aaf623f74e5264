// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace winding
{

/**
 * The places of points: each position once, with the points that stand there. Searches for
 * neighbours look among places: the nearest neighbours of one of many equal points would be the
 * other equal ones, which say nothing of its surroundings.
 *
 * Places that are near to each other mostly have numbers near to each other. Guaranteed: the result
 * is the same for any executor; the places and their order depend on the positions and on how many
 * points are at each, not on the order of the points; the points of a place stand in ascending
 * order.
 */
class DistinctPoints
{
public:
  /// Up to 2³² − 1 positions, all finite; they are multiplied by scale (UnitScale.h). Throws
  /// Interrupted. The object keeps up to 32 bytes per point.
  DistinctPoints(const std::vector<Eigen::Vector3d>& positions, double scale, Executor& executor);

  std::size_t size() const { return positions_.size(); }
  double scale() const { return scale_; }

  /// The scaled positions, by place.
  const std::vector<Eigen::Vector3d>& positions() const { return positions_; }

  ///@{
  /// The numbers of the points at a place.
  const std::uint32_t* begin(std::size_t place) const { return &points_[starts_[place]]; }
  const std::uint32_t* end(std::size_t place) const { return begin(place) + count(place); }
  std::uint32_t count(std::size_t place) const { return starts_[place + 1] - starts_[place]; }
  ///@}

  /// Returns the value of each point's place, by point.
  template <class Value> std::vector<Value> byPoint(const std::vector<Value>& byPlace) const
  {
    std::vector<Value> values(points_.size());
    for (std::size_t place = 0; place < this->size(); ++place)
    {
      for (const std::uint32_t* point = this->begin(place); point != this->end(place); ++point)
      {
        values[*point] = byPlace[place];
      }
    }
    return values;
  }

private:
  double scale_;
  std::vector<Eigen::Vector3d> positions_;
  std::vector<std::uint32_t> starts_; ///< where each place begins in points_; at last its size
  std::vector<std::uint32_t> points_;
};

} // namespace winding
