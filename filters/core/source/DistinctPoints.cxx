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

  // Equal points share a leaf, and sorting the leaf puts them side by side.
  constexpr std::size_t leafSize = 16, nodesPerBlock = 256;
  const SourceTree tree(scaled, leafSize, executor);
  points_ = tree.order();
  const auto isBefore = [&scaled](std::uint32_t a, std::uint32_t b)
  {
    const Eigen::Vector3d &p = scaled[a], &q = scaled[b];
    return p == q ? a < b
                  : std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
  };
  runBlocks(
    tree.nodes().size(), nodesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const SourceNode& node = tree.nodes()[i];
        if (node.children == 0)
        {
          std::sort(points_.begin() + node.begin, points_.begin() + node.end, isBefore);
        }
      }
    },
    executor);

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
