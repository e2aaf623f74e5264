#include "level/Bricks.h"

#include "base/Refusal.h"

#include <algorithm>
#include <string>

namespace winding
{

std::size_t Bricks::size() const
{
  return sampleCount(this->whole());
}

Extent Bricks::whole() const
{
  return {0, counts[0] - 1, 0, counts[1] - 1, 0, counts[2] - 1};
}

Extent Bricks::voxelsOf(const Extent& bricks, const Grid& grid) const
{
  Extent voxels;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int most = grid.dimensions[static_cast<int>(axis)];
    const long long end = (static_cast<long long>(bricks[2 * axis + 1]) + 1) << depth;
    voxels[2 * axis] = bricks[2 * axis] << depth;
    voxels[2 * axis + 1] = static_cast<int>(std::min<long long>(most, end) - 1);
  }
  return voxels;
}

Extent Bricks::voxelsOf(const Eigen::Vector3i& brick, const Grid& grid) const
{
  return this->voxelsOf(Extent{brick[0], brick[0], brick[1], brick[1], brick[2], brick[2]}, grid);
}

Bricks bricksOf(const Grid& grid)
{
  constexpr int leastDepth = 4;
  constexpr int mostDepth = 10; // 2^30 voxels of a brick can be numbered as vertices of a tree
  constexpr std::size_t mostBricks = 1 << 15;
  Bricks bricks;
  for (bricks.depth = leastDepth; bricks.depth <= mostDepth; ++bricks.depth)
  {
    bricks.counts = ((grid.dimensions.array() - 1) / bricks.side() + 1).matrix();
    if (bricks.size() <= mostBricks)
    {
      return bricks;
    }
  }
  throw Refusal("choose larger voxels: a grid of " + std::to_string(grid.dimensions[0]) + " x " +
                std::to_string(grid.dimensions[1]) + " x " + std::to_string(grid.dimensions[2]) +
                " voxels has too many for a hyper tree grid");
}

} // namespace winding
