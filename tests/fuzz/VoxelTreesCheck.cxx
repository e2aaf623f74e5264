// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"
#include "FieldValues.h"
#include "RandomSources.h"

#include "level/VoxelTrees.h"
#include "support/ExtentsOfField.h"
#include "support/VoxelLeaves.h"

#include <cmath>

/**
 * @file
 * The leaf of each voxel is compared with the field: sides are the same, winding numbers too where
 * whole rows are integers, and within half the tolerance elsewhere.
 */
namespace fuzz
{

namespace
{

using namespace winding;

std::vector<VoxelTree> treesOf(
  const Field& field, const Grid& grid, const VoxelTreeOptions& options, Executor& executor)
{
  VoxelTrees trees(field, grid, options, shapes::extentsOf(field, grid, options, executor));
  std::vector<VoxelTree> all;
  while (!trees.isDone())
  {
    for (VoxelTree& tree : trees.advance(executor))
    {
      all.push_back(std::move(tree));
    }
  }
  return all;
}

} // namespace

std::string checkVoxelTrees(Choices& choices)
{
  const auto field = randomField(choices);
  if (!field || field->info().primitives == 0)
  {
    return {};
  }
  Grid grid = randomGrid(choices, field->info().bounds);
  if (choices.oneIn(3))
  {
    // Bricks have 16 voxels a side; more of them make several.
    grid.dimensions[choices.below(3)] += 16;
  }
  VoxelTreeOptions options;
  options.rule = randomRule(choices);
  options.threshold = randomThreshold(choices);
  options.withValues = !choices.oneIn(3);
  options.asDouble = choices.oneIn(3);
  options.tolerance = choices.oneIn(4) ? 0 : choices.between(0.001, 1);
  SerialExecutor serial;
  BackwardExecutor backward;
  const std::vector<VoxelTree> trees = treesOf(*field, grid, options, serial);
  const std::vector<VoxelTree> again = treesOf(*field, grid, options, backward);

  const Extent whole = grid.wholeExtent();
  std::vector<unsigned char> inside(sampleCount(whole));
  std::vector<float> values(inside.size());
  // Without values, the side is that of single precision (FieldOutput.h).
  const bool isDouble = options.asDouble && options.withValues;
  std::vector<double> doubleValues(isDouble ? inside.size() : 0);
  FieldOutput output;
  output.values = values.data();
  output.doubleValues = isDouble ? doubleValues.data() : nullptr;
  output.inside = inside.data();
  output.rule = options.rule;
  output.threshold = options.threshold;
  field->evaluate(grid, whole, output, serial);
  const Bricks bricks = bricksOf(grid);
  const double tolerance = field->integerRows() ? 0 : options.tolerance;
  for (std::size_t n = 0; n < inside.size(); ++n)
  {
    const Eigen::Vector3i voxel = sampleIndex(whole, n);
    const Eigen::Vector3i brick = voxel / bricks.side();
    const std::size_t number = sampleNumber(bricks.whole(), brick);
    const VoxelTree& tree = trees[number];
    const std::size_t leaf = leafOf(tree, voxel - brick * bricks.side(), bricks.depth);
    const double value = isDouble ? doubleValues[n] : double{values[n]};
    // The middle is rounded to the precision of the array.
    const double rounding = tolerance == 0 ? 0 : 1e-7 * std::abs(value);
    if (tree.isBeyond[leaf] || tree.inside[leaf] != inside[n])
    {
      return "voxel " + std::to_string(n) + " has another side than its leaf";
    }
    if (options.withValues &&
        !(std::abs(tree.values[leaf] - value) <= tolerance / 2 * (1 + 1e-6) + rounding))
    {
      return "voxel " + std::to_string(n) + " has the value " + std::to_string(value) +
             ", and its leaf " + std::to_string(tree.values[leaf]);
    }
    if (tree.values != again[number].values || tree.isParent != again[number].isParent)
    {
      return "trees depend on the executor";
    }
  }
  return {};
}

} // namespace fuzz
