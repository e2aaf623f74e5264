#include "source/DistinctPoints.h"

#include "source/SourceTree.h"

#include <algorithm>

namespace winding
{

DistinctPoints::DistinctPoints(
  const std::vector<Eigen::Vector3d>& positions, double scale, Executor& executor)
  : scale_(scale)
{
  std::vector<Eigen::Vector3d> scaled(positions.size());
  std::transform(positions.begin(), positions.end(), scaled.begin(),
    [scale](const Eigen::Vector3d& position) { return Eigen::Vector3d(position * scale); });

  // Equal points share a leaf and stand side by side there, in the order of their numbers.
  constexpr std::size_t leafSize = 16;
  points_ = SourceTree(scaled, leafSize, executor).order();

  positions_.reserve(points_.size());
  starts_.reserve(points_.size() + 1);
  for (std::size_t i = 0; i < points_.size(); ++i)
  {
    if (i == 0 || scaled[points_[i]] != positions_.back())
    {
      positions_.push_back(scaled[points_[i]]);
      starts_.push_back(static_cast<std::uint32_t>(i));
    }
  }
  starts_.push_back(static_cast<std::uint32_t>(points_.size()));
}

} // namespace winding
