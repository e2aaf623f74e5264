#pragma once

#include "level/VoxelTree.h"
#include "source/Grid.h"

#include <algorithm>

namespace winding
{

/// The least and the largest number in each cube of a brick, for all cubes that lie in the grid as
/// a whole. Memory: two numbers for each eight voxels, and a seventh more.
template <class Number> class CubeRanges
{
public:
  struct Range
  {
    Number least, largest;
  };

  /// The numbers are those of the samples of an extent, of which `brick` is a part. The pointer is
  /// kept.
  CubeRanges(const Number* numbers, const Extent& extent, const Extent& brick)
    : first_(numbers + sampleNumber(extent, brick[0], brick[2], brick[4]))
    , stepOfRow_(static_cast<std::size_t>(extent[1] - extent[0] + 1))
    , stepOfLayer_(stepOfRow_ * static_cast<std::size_t>(extent[3] - extent[2] + 1))
  {
    Eigen::Vector3i counts(
      brick[1] - brick[0] + 1, brick[3] - brick[2] + 1, brick[5] - brick[4] + 1);
    for (int level = 1; (counts /= 2).minCoeff() > 0; ++level)
    {
      Level made{counts, {}};
      made.ranges.reserve(static_cast<std::size_t>(counts.prod()));
      for (int k = 0; k < counts[2]; ++k)
      {
        for (int j = 0; j < counts[1]; ++j)
        {
          for (int i = 0; i < counts[0]; ++i)
          {
            made.ranges.push_back(this->ofChildren({level, {i, j, k}}));
          }
        }
      }
      levels_.push_back(std::move(made));
    }
  }

  Range operator[](const VoxelCube& cube) const
  {
    const Eigen::Vector3i& at = cube.index;
    if (cube.level == 0)
    {
      const Number number =
        first_[static_cast<std::size_t>(at[2]) * stepOfLayer_ +
               static_cast<std::size_t>(at[1]) * stepOfRow_ + static_cast<std::size_t>(at[0])];
      return {number, number};
    }
    const Level& level = levels_[static_cast<std::size_t>(cube.level) - 1];
    return level.ranges[static_cast<std::size_t>(
      (at[2] * level.counts[1] + at[1]) * level.counts[0] + at[0])];
  }

private:
  struct Level
  {
    Eigen::Vector3i counts;
    std::vector<Range> ranges;
  };

  Range ofChildren(const VoxelCube& cube) const
  {
    const VoxelCube first = {cube.level - 1, 2 * cube.index};
    Range range = (*this)[first];
    for (int child = 1; child < 8; ++child)
    {
      const Eigen::Vector3i step(child & 1, child >> 1 & 1, child >> 2);
      const Range other = (*this)[{first.level, first.index + step}];
      range.least = std::min(range.least, other.least);
      range.largest = std::max(range.largest, other.largest);
    }
    return range;
  }

  const Number* first_;
  std::size_t stepOfRow_, stepOfLayer_;
  std::vector<Level> levels_; ///< of 2, 4, 8 … voxels a side
};

} // namespace winding
