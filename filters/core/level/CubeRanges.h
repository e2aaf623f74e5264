// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
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

  /// The numbers belong to the samples of an extent, and `brick` is a part of it. The pointer is
  /// kept.
  CubeRanges(const Number* numbers, const Extent& extent, const Extent& brick)
    : first_(numbers + sampleNumber(extent, brick[0], brick[2], brick[4]))
    , stepOfRow_(static_cast<std::size_t>(extent[1] - extent[0] + 1))
    , stepOfLayer_(stepOfRow_ * static_cast<std::size_t>(extent[3] - extent[2] + 1))
  {
    const Eigen::Vector3i counts(
      brick[1] - brick[0] + 1, brick[3] - brick[2] + 1, brick[5] - brick[4] + 1);
    if (counts.minCoeff() > 1)
    {
      this->addLevel(counts / 2, [this](int j, int k) { return this->row(j, k); });
    }
    while (!levels_.empty() && levels_.back().counts.minCoeff() > 1)
    {
      this->addLevel(
        levels_.back().counts / 2, [this](int j, int k) { return this->levels_.back().row(j, k); });
    }
  }

  Range operator[](const VoxelCube& cube) const
  {
    const Eigen::Vector3i& at = cube.index;
    if (cube.level == 0)
    {
      const Number number = this->row(at[1], at[2])[at[0]];
      return {number, number};
    }
    return levels_[static_cast<std::size_t>(cube.level) - 1].row(at[1], at[2])[at[0]];
  }

private:
  struct Level
  {
    Eigen::Vector3i counts;
    std::vector<Range> ranges;

    const Range* row(int j, int k) const
    {
      return ranges.data() + static_cast<std::ptrdiff_t>((k * counts[1] + j) * counts[0]);
    }
  };

  const Number* row(int j, int k) const
  {
    return first_ + static_cast<std::size_t>(k) * stepOfLayer_ +
           static_cast<std::size_t>(j) * stepOfRow_;
  }

  static Number leastOf(Number number) { return number; }
  static Number leastOf(const Range& range) { return range.least; }
  static Number largestOf(Number number) { return number; }
  static Number largestOf(const Range& range) { return range.largest; }

  /// Adds a level of cubes, each of the eight of the level below that rowOf(j, k) has.
  template <class RowOf> void addLevel(const Eigen::Vector3i& counts, const RowOf& rowOf)
  {
    Level level{counts, std::vector<Range>(static_cast<std::size_t>(counts.prod()))};
    Range* range = level.ranges.data();
    for (int k = 0; k < counts[2]; ++k)
    {
      for (int j = 0; j < counts[1]; ++j)
      {
        const auto* const a = rowOf(2 * j, 2 * k);
        const auto* const b = rowOf(2 * j + 1, 2 * k);
        const auto* const c = rowOf(2 * j, 2 * k + 1);
        const auto* const d = rowOf(2 * j + 1, 2 * k + 1);
        for (int i = 0; i < counts[0]; ++i, ++range)
        {
          range->least = leastOf(a[2 * i]);
          range->largest = largestOf(a[2 * i]);
          for (const auto* const two : {a + 2 * i, b + 2 * i, c + 2 * i, d + 2 * i})
          {
            range->least = std::min({range->least, leastOf(two[0]), leastOf(two[1])});
            range->largest = std::max({range->largest, largestOf(two[0]), largestOf(two[1])});
          }
        }
      }
    }
    levels_.push_back(std::move(level));
  }

  const Number* first_;
  std::size_t stepOfRow_, stepOfLayer_;
  std::vector<Level> levels_; ///< of 2, 4, 8 … voxels a side
};

} // namespace winding
