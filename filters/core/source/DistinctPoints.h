#pragma once

#include "base/Executor.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace winding
{

/**
 * The places of points: each position once, with the points that stand there. What looks for
 * neighbours looks among places, for of many equal points the nearest are all of them, and say nothing.
 *
 * Places that are near to each other mostly have numbers near to each other. Guaranteed: the same for
 * any executor; the places and their order depend on the positions and on how many points are at each,
 * not on the order of the points; the points of a place stand in ascending order.
 */
class DistinctPoints
{
public:
  /// Up to 2³² − 1 positions, all finite; they are multiplied by scale (UnitScale.h). Throws
  /// Interrupted. 32 bytes per place and 4 per point remain.
  DistinctPoints(const std::vector<Eigen::Vector3d>& positions, double scale, Executor& executor);

  std::size_t size() const { return positions_.size(); }
  double scale() const { return scale_; }

  /// By place, scaled.
  const std::vector<Eigen::Vector3d>& positions() const { return positions_; }

  ///@{
  /// The numbers of the points at a place.
  const std::uint32_t* begin(std::size_t place) const { return &points_[starts_[place]]; }
  const std::uint32_t* end(std::size_t place) const { return begin(place) + count(place); }
  std::uint32_t count(std::size_t place) const { return starts_[place + 1] - starts_[place]; }
  ///@}

private:
  double scale_;
  std::vector<Eigen::Vector3d> positions_;
  std::vector<std::uint32_t> starts_; ///< one more than places
  std::vector<std::uint32_t> points_;
};

} // namespace winding
