// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/VoxelTrees.h"

#include "level/CubeRanges.h"
#include "level/RunsOfLayers.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace winding
{

namespace
{

constexpr double mostBytesAtWork = 128.0 * 1024 * 1024;

double bytesPerVoxel(const VoxelTreeOptions& options)
{
  const double ofValue = options.asDouble ? sizeof(double) : sizeof(float);
  return 1 + (options.withValues ? ofValue : 0) + (options.withCoverage ? sizeof(float) : 0);
}

/// The bricks along each axis whose voxels are at work together.
Eigen::Vector3i bricksPerGroup(
  const Bricks& bricks, const Grid& grid, const VoxelTreeOptions& options, bool isOfRuns)
{
  Eigen::Vector3i group(bricks.counts[0], bricks.counts[1], 1);
  if (!isOfRuns)
  {
    const auto voxels = [&](int axis)
    {
      return static_cast<double>(std::min(grid.dimensions[axis], bricks.side()));
    };
    const double bricksAtWork =
      std::max(1.0, mostBytesAtWork / (bytesPerVoxel(options) * voxels(0) * voxels(1) * voxels(2)));
    group[0] = static_cast<int>(std::min<double>(group[0], bricksAtWork));
    group[1] = group[0] < bricks.counts[0]
                 ? 1
                 : static_cast<int>(std::clamp<double>(bricksAtWork / group[0], 1, group[1]));
  }
  return group;
}

} // namespace

bool VoxelTrees::areMadeOfRuns(const Field& field, const VoxelTreeOptions& options)
{
  return field.integerRows() && options.byCenters && !options.withCoverage;
}

double VoxelTrees::bytesAtWork(
  const Field& field, const Grid& grid, const VoxelTreeOptions& options)
{
  const Bricks bricks = bricksOf(grid);
  if (areMadeOfRuns(field, options))
  {
    constexpr double bytesPerRow = 40; // of rows with a few runs
    return bytesPerRow * grid.dimensions[1] * std::min(bricks.side(), grid.dimensions[2]);
  }
  double voxels = 1;
  const Eigen::Vector3i group = bricksPerGroup(bricks, grid, options, false);
  for (int axis = 0; axis < 3; ++axis)
  {
    voxels *= std::min<double>(grid.dimensions[axis], std::ldexp(group[axis], bricks.depth));
  }
  return bytesPerVoxel(options) * voxels;
}

VoxelTrees::VoxelTrees(
  const Field& field, const Grid& grid, const VoxelTreeOptions& options, const Evaluate& evaluate)
  : field_(field)
  , grid_(grid)
  , options_(options)
  , evaluate_(evaluate)
  , bricks_(bricksOf(grid))
  , perGroup_(bricksPerGroup(bricks_, grid, options, areMadeOfRuns(field, options)))
  , groupCounts_(((bricks_.counts - Eigen::Vector3i::Ones()).array() / perGroup_.array() + 1))
  , groups_(sampleCount({0, groupCounts_[0] - 1, 0, groupCounts_[1] - 1, 0, groupCounts_[2] - 1}))
{
  if (field.integerRows())
  {
    options_.tolerance = 0; // integers need none
  }
}

Extent VoxelTrees::bricksOfNext() const
{
  const Eigen::Vector3i group = sampleIndex(
    {0, groupCounts_[0] - 1, 0, groupCounts_[1] - 1, 0, groupCounts_[2] - 1}, nextGroup_);
  Extent bricks;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int first = group[axis] * perGroup_[axis];
    bricks[2 * static_cast<std::size_t>(axis)] = first;
    bricks[2 * static_cast<std::size_t>(axis) + 1] =
      std::min(first + perGroup_[axis], bricks_.counts[axis]) - 1;
  }
  return bricks;
}

std::vector<VoxelTree> VoxelTrees::advance(Executor& executor)
{
  const Extent bricks = this->bricksOfNext();
  std::vector<VoxelTree> trees = areMadeOfRuns(field_, options_) ? this->ofRuns(bricks, executor)
                                                                 : this->ofArrays(bricks, executor);
  ++nextGroup_;
  return trees;
}

std::vector<VoxelTree> VoxelTrees::ofRuns(const Extent& bricks, Executor& executor)
{
  const Extent layers = bricks_.voxelsOf(bricks, grid_);
  const auto isInsideOf = [this](int value)
  {
    return isInside(
      options_.asDouble ? value : static_cast<float>(value), options_.rule, options_.threshold);
  };
  const RunsOfLayers runs(
    *field_.integerRows(), grid_, layers[4], layers[5],
    [&](int value) { return options_.withValues ? value : static_cast<int>(isInsideOf(value)); },
    options_.rule, options_.threshold, executor);
  sides_ += runs.sides();
  inside_ += runs.sides().inside;
  std::vector<VoxelTree> trees(sampleCount(bricks));
  runBlocks(
    trees.size(), 1,
    [&](std::size_t n, std::size_t, std::size_t)
    {
      const Extent voxels = bricks_.voxelsOf(sampleIndex(bricks, n), grid_);
      const Eigen::Vector3i first(voxels[0], voxels[2], voxels[4]);
      VoxelTreeBuilder builder(bricks_.depth,
        Eigen::Vector3i(voxels[1], voxels[3], voxels[5]) - first + Eigen::Vector3i::Ones());
      trees[n] = builder.build(
        [&](const VoxelCube& cube)
        {
          const Eigen::Vector3i at = first + cube.firstVoxel();
          return runs.areEqual(at[0], at[1], at[2], 1 << cube.level);
        },
        [&](const VoxelCube& cube)
        {
          const Eigen::Vector3i at = first + cube.firstVoxel();
          const int label = runs.label(at[0], at[1], at[2]);
          return options_.withValues ? VoxelState{static_cast<double>(label), isInsideOf(label), 0}
                                     : VoxelState{0, label != 0, 0};
        });
    },
    executor);
  return trees;
}

std::vector<VoxelTree> VoxelTrees::ofArrays(const Extent& bricks, Executor& executor)
{
  const std::size_t voxels = sampleCount(bricks_.voxelsOf(bricks, grid_));
  std::vector<float> values(options_.withValues && !options_.asDouble ? voxels : 0);
  std::vector<double> doubleValues(options_.withValues && options_.asDouble ? voxels : 0);
  std::vector<unsigned char> inside(voxels);
  std::vector<float> coverage(options_.withCoverage ? voxels : 0);
  VoxelArrays arrays;
  arrays.values = values.empty() ? nullptr : values.data();
  arrays.doubleValues = doubleValues.empty() ? nullptr : doubleValues.data();
  arrays.inside = inside.data();
  arrays.coverage = coverage.empty() ? nullptr : coverage.data();
  return options_.asDouble ? this->ofArrays(bricks, doubleValues, arrays, executor)
                           : this->ofArrays(bricks, values, arrays, executor);
}

template <class Number>
std::vector<VoxelTree> VoxelTrees::ofArrays(
  const Extent& bricks, std::vector<Number>& values, const VoxelArrays& arrays, Executor& executor)
{
  const Extent extent = bricks_.voxelsOf(bricks, grid_);
  const std::size_t count = sampleCount(extent);
  evaluate_(extent, arrays);
  inside_ += static_cast<std::size_t>(std::count(arrays.inside, arrays.inside + count, 1));

  using SideRanges = CubeRanges<unsigned char>;
  using ValueRanges = CubeRanges<Number>;
  using CoverageRanges = CubeRanges<float>;
  const auto areClose = [this](const typename ValueRanges::Range& range)
  {
    return range.least == range.largest ||
           static_cast<double>(range.largest) - static_cast<double>(range.least) <=
             options_.tolerance;
  };
  const auto middle = [](const typename ValueRanges::Range& range)
  {
    return range.least == range.largest
             ? range.least
             : static_cast<Number>(
                 0.5 * (static_cast<double>(range.least) + static_cast<double>(range.largest)));
  };
  std::vector<VoxelTree> trees(sampleCount(bricks));
  runBlocks(
    trees.size(), 1,
    [&](std::size_t n, std::size_t, std::size_t)
    {
      const Extent voxels = bricks_.voxelsOf(sampleIndex(bricks, n), grid_);
      const SideRanges sides(arrays.inside, extent, voxels);
      std::optional<ValueRanges> numbers;
      std::optional<CoverageRanges> shares;
      if (options_.withValues)
      {
        numbers.emplace(values.data(), extent, voxels);
      }
      if (options_.withCoverage)
      {
        shares.emplace(arrays.coverage, extent, voxels);
      }
      const auto isSideOfMiddle = [&](const VoxelCube& cube)
      {
        // The middle of two values that are inside may be outside where both signs are.
        return !options_.byCenters || isInside(middle((*numbers)[cube]), options_.rule,
                                        options_.threshold) == (sides[cube].least != 0);
      };
      VoxelTreeBuilder builder(
        bricks_.depth, Eigen::Vector3i(voxels[1] - voxels[0] + 1, voxels[3] - voxels[2] + 1,
                         voxels[5] - voxels[4] + 1));
      trees[n] = builder.build(
        [&](const VoxelCube& cube)
        {
          return sides[cube].least == sides[cube].largest &&
                 (!shares || (*shares)[cube].least == (*shares)[cube].largest) &&
                 (!numbers || (areClose((*numbers)[cube]) && isSideOfMiddle(cube)));
        },
        [&](const VoxelCube& cube)
        {
          return VoxelState{numbers ? static_cast<double>(middle((*numbers)[cube])) : 0,
            sides[cube].least != 0, shares ? (*shares)[cube].least : 0};
        });
    },
    executor);
  return trees;
}

} // namespace winding
