// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
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
  constexpr int mostDepth = 10; // a tree numbers its vertices, 2^30 voxels among them, by 32 bits
  constexpr double wantedBricks = 1 << 12, mostBricks = 1 << 20;
  Bricks bricks;
  double count = 0;
  for (bricks.depth = leastDepth;; ++bricks.depth)
  {
    bricks.counts = ((grid.dimensions.array() - 1) / bricks.side() + 1).matrix();
    count = bricks.counts.cast<double>().prod(); // more than integers can count
    if (count <= wantedBricks || bricks.depth == mostDepth)
    {
      break;
    }
  }
  if (count > mostBricks)
  {
    throw Refusal(Message("too many voxels for a hyper tree grid", {largerVoxels()},
      "the grid has " + std::to_string(grid.dimensions[0]) + " x " +
        std::to_string(grid.dimensions[1]) + " x " + std::to_string(grid.dimensions[2])));
  }
  return bricks;
}

} // namespace winding
