// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "source/DistinctPoints.h"

#include "source/SourceTree.h"

#include <numeric>

namespace winding
{

DistinctPoints::DistinctPoints(
  const std::vector<Eigen::Vector3d>& positions, double scale, Executor& executor)
  : scale_(scale)
{
  std::vector<Eigen::Vector3d> scaled(positions.size());
  forEachItem(
    positions.size(), [&](std::size_t i) { scaled[i] = positions[i] * scale; }, executor);

  // Equal points share a leaf and stand side by side there, in the order of their numbers.
  constexpr std::size_t leafSize = 16;
  points_ = SourceTree(scaled, leafSize, executor).order();

  const auto beginsPlace = [&](std::size_t i)
  {
    return i == 0 || scaled[points_[i]] != scaled[points_[i - 1]];
  };
  constexpr std::size_t pointsPerBlock = 16384;
  std::vector<std::size_t> firstPlaces((points_.size() + pointsPerBlock - 1) / pointsPerBlock + 1);
  runBlocks(
    points_.size(), pointsPerBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      std::size_t count = 0;
      for (std::size_t i = first; i < last; ++i)
      {
        count += beginsPlace(i);
      }
      firstPlaces[block + 1] = count;
    },
    executor);
  std::partial_sum(firstPlaces.begin(), firstPlaces.end(), firstPlaces.begin());
  positions_.resize(firstPlaces.back());
  starts_.resize(firstPlaces.back() + 1);
  runBlocks(
    points_.size(), pointsPerBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      std::size_t place = firstPlaces[block];
      for (std::size_t i = first; i < last; ++i)
      {
        if (beginsPlace(i))
        {
          positions_[place] = scaled[points_[i]];
          starts_[place] = static_cast<std::uint32_t>(i);
          ++place;
        }
      }
    },
    executor);
  starts_.back() = static_cast<std::uint32_t>(points_.size());
}

} // namespace winding
