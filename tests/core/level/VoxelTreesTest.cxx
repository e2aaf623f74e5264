// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/VoxelTrees.h"
#include "base/Executor.h"
#include "base/Refusal.h"
#include "level/RunsOfLayers.h"
#include "support/ExtentsOfField.h"
#include "support/Interruption.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"
#include "support/VoxelLeaves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

using namespace shapes;
using namespace winding;

Grid gridOf(int nx, int ny, int nz)
{
  Grid grid;
  grid.dimensions = {nx, ny, nz};
  grid.spacing = Eigen::Vector3d::Constant(2.2).cwiseQuotient(grid.dimensions.cast<double>());
  grid.firstSample = Eigen::Vector3d::Constant(-1.1) + 0.5 * grid.spacing;
  return grid;
}

std::shared_ptr<const Field> fieldOf(const Mesh& mesh, Method method = Method::automatic)
{
  SerialExecutor serial;
  FieldOptions options;
  options.method = method;
  return Field::build(std::vector<TrianglesView>{mesh.view()}, options, serial);
}

std::vector<VoxelTree> treesOf(
  const Field& field, const Grid& grid, const VoxelTreeOptions& options, Executor& executor)
{
  VoxelTrees trees(field, grid, options, extentsOf(field, grid, options, executor));
  std::vector<VoxelTree> all;
  while (!trees.isDone())
  {
    EXPECT_LT(trees.progress(), trees.nextProgress());
    for (VoxelTree& tree : trees.advance(executor))
    {
      all.push_back(std::move(tree));
    }
  }
  EXPECT_EQ(all.size(), trees.bricks().size());
  EXPECT_EQ(trees.progress(), 1);
  return all;
}

/// Compares each voxel's leaf with the field. Returns the largest difference of values.
double expectTheField(const std::vector<VoxelTree>& trees, const Field& field, const Grid& grid,
  const VoxelTreeOptions& options)
{
  const Extent whole = grid.wholeExtent();
  std::vector<float> values(sampleCount(whole));
  std::vector<unsigned char> inside(values.size());
  FieldOutput output;
  output.values = values.data();
  output.inside = inside.data();
  output.rule = options.rule;
  output.threshold = options.threshold;
  SerialExecutor serial;
  field.evaluate(grid, whole, output, serial);
  const Bricks bricks = bricksOf(grid);
  double largest = 0;
  std::size_t wrongSides = 0;
  for (std::size_t n = 0; n < values.size(); ++n)
  {
    const Eigen::Vector3i voxel = sampleIndex(whole, n);
    const Eigen::Vector3i brick = voxel / bricks.side();
    const VoxelTree& tree = trees[sampleNumber(bricks.whole(), brick)];
    const std::size_t leaf = leafOf(tree, voxel - brick * bricks.side(), bricks.depth);
    EXPECT_FALSE(tree.isBeyond[leaf]);
    wrongSides += tree.inside[leaf] != inside[n];
    if (options.withValues)
    {
      largest = std::max(largest, std::abs(tree.values[leaf] - double{values[n]}));
    }
  }
  EXPECT_EQ(wrongSides, 0u);
  return largest;
}

TEST(VoxelTrees, BricksCoverAGridAndNoMore)
{
  for (const auto& [nx, ny, nz, depth] : {std::array{1, 1, 1, 4}, std::array{64, 51, 64, 4},
         std::array{257, 3, 1, 4}, std::array{512, 512, 512, 5}, std::array{4096, 3259, 4064, 8},
         std::array{1 << 20, 1 << 20, 1, 10}})
  {
    const Grid grid = gridOf(nx, ny, nz);
    const Bricks bricks = bricksOf(grid);
    EXPECT_EQ(bricks.depth, depth);
    EXPECT_EQ(bricks.voxelsOf(bricks.whole(), grid), grid.wholeExtent());
    const Extent last = bricks.voxelsOf(bricks.counts - Eigen::Vector3i::Ones(), grid);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_LE(
        last[2 * static_cast<std::size_t>(axis)], last[2 * static_cast<std::size_t>(axis) + 1]);
    }
  }
  const int most = std::numeric_limits<int>::max() - 1;
  EXPECT_THROW(bricksOf(gridOf(most, 1, 1)), Refusal);
  EXPECT_THROW(bricksOf(gridOf(most, most, most)), Refusal);
}

TEST(VoxelTrees, RunsTellWhetherCubesAreOfOneValue)
{
  const Mesh ball = icosphere(2);
  const auto field = fieldOf(ball.with(ball.mapped([](const Point& p) -> Point { return p / 2; })));
  const Grid grid = gridOf(23, 19, 21);
  SerialExecutor serial;
  const auto same = [](int value)
  {
    return value;
  };
  const RunsOfLayers runs(
    *field->integerRows(), grid, 3, 17, same, InsideRule::signedThreshold, 0.5, serial);
  Extent extent = grid.wholeExtent();
  extent[4] = 3;
  extent[5] = 17;
  std::vector<float> values(sampleCount(extent));
  FieldOutput output;
  output.values = values.data();
  field->evaluate(grid, extent, output, serial);
  const auto valueAt = [&](int i, int j, int k)
  {
    return values[sampleNumber(extent, i, j, k)];
  };
  for (int size : {1, 2, 4})
  {
    for (int k = 3; k + size <= 18; ++k)
    {
      for (int j = 0; j + size <= 19; ++j)
      {
        for (int i = 0; i + size <= 23; ++i)
        {
          bool areEqual = true;
          for (int n = 0; n < size * size * size; ++n)
          {
            areEqual &=
              valueAt(i + n % size, j + n / size % size, k + n / size / size) == valueAt(i, j, k);
          }
          ASSERT_EQ(runs.areEqual(i, j, k, size), areEqual);
        }
      }
    }
  }
  EXPECT_EQ(runs.label(11, 9, 10), 2);
  EXPECT_EQ(runs.sides().samples, values.size());
  EXPECT_EQ(runs.sides().inside, static_cast<std::size_t>(std::count_if(values.begin(),
                                   values.end(), [](float value) { return value >= 0.5F; })));
  const RunsOfLayers odd(*field->integerRows(), grid, 3, 17, same, InsideRule::odd, 0.5, serial);
  EXPECT_EQ(odd.sides().inside, static_cast<std::size_t>(std::count_if(values.begin(), values.end(),
                                  [](float value) { return std::lround(value) % 2 != 0; })));
  EXPECT_LT(odd.sides().inside, runs.sides().inside);
}

TEST(VoxelTrees, HaveTheFieldAtEveryVoxel)
{
  const Mesh ball = icosphere(3);
  const Mesh nested =
    ball.with(ball.mapped([](const Point& p) -> Point { return 0.5 * p + Point(0.1, 0.2, 0.3); }));
  struct Case
  {
    std::shared_ptr<const Field> field;
    bool isLossless;
  };
  const Case cases[] = {{fieldOf(nested), true}, {fieldOf(ball.part(0, 1000)), false},
    {fieldOf(nested, Method::hierarchical), false}, {fieldOf(Mesh()), true}};
  SerialExecutor serial;
  for (const Case& c : cases)
  {
    for (const Grid& grid : {gridOf(40, 33, 16), gridOf(7, 50, 1), gridOf(32, 32, 32)})
    {
      for (const bool withValues : {true, false})
      {
        for (const bool asDouble : {false, true})
        {
          VoxelTreeOptions options;
          options.withValues = withValues;
          options.asDouble = asDouble;
          options.tolerance = 0.02;
          const double largest =
            expectTheField(treesOf(*c.field, grid, options, serial), *c.field, grid, options);
          EXPECT_LE(largest, c.isLossless ? 0 : 0.01 + 1e-6);
        }
      }
    }
  }
}

TEST(VoxelTrees, AFieldThatIsSmoothIsDividedByTheTolerance)
{
  const auto field = fieldOf(icosphere(3).part(0, 1000));
  const Grid grid = gridOf(40, 40, 40);
  SerialExecutor serial;
  std::size_t before = std::numeric_limits<std::size_t>::max();
  for (const double tolerance : {0.0, 0.01, 0.1, 1.0})
  {
    VoxelTreeOptions options;
    options.tolerance = tolerance;
    const std::vector<VoxelTree> trees = treesOf(*field, grid, options, serial);
    EXPECT_LE(expectTheField(trees, *field, grid, options), tolerance / 2 + 1e-6);
    std::size_t vertices = 0;
    for (const VoxelTree& tree : trees)
    {
      vertices += tree.size();
    }
    EXPECT_LT(vertices, before);
    before = vertices;
  }
}

TEST(VoxelTrees, ALeafOfBothSignsHasItsValueOnItsSide)
{
  // Two cubes of opposite senses share a face, so that w is +1 next to -1. By their sizes all of
  // these voxels are inside, but the middle of both values, 0, would be outside.
  const Mesh twoCubes =
    cube({-1, -1, -1}, {0.3, 1, 1}).with(cube({0.3, -1, -1}, {1, 1, 1}).reversed());
  const auto field = fieldOf(twoCubes, Method::hierarchical);
  SerialExecutor serial;
  VoxelTreeOptions options;
  options.rule = InsideRule::absoluteThreshold;
  options.tolerance = 2.5;
  const Grid grid = gridOf(32, 32, 32);
  const std::vector<VoxelTree> trees = treesOf(*field, grid, options, serial);
  EXPECT_LE(expectTheField(trees, *field, grid, options), options.tolerance / 2);
  std::size_t leaves = 0;
  for (const VoxelTree& tree : trees)
  {
    for (std::size_t vertex = 0; vertex < tree.size(); ++vertex)
    {
      const bool isParent = vertex < tree.isParent.size() && tree.isParent[vertex];
      if (!isParent && !tree.isBeyond[vertex])
      {
        ++leaves;
        EXPECT_EQ(
          isInside(tree.values[vertex], options.rule, options.threshold), tree.inside[vertex] != 0);
      }
    }
  }
  EXPECT_GT(leaves, trees.size());
}

TEST(VoxelTrees, TellOfTheInsideOfAllBricks)
{
  // The sphere lies in the first layer of bricks of three, which are made one after the other.
  const auto field = fieldOf(icosphere(2), Method::hierarchical);
  Grid grid = gridOf(16, 16, 48);
  grid.spacing[2] = grid.spacing[0];
  grid.firstSample[2] = grid.firstSample[0];
  SerialExecutor serial;
  VoxelTreeOptions options;
  options.withValues = false;
  VoxelTrees trees(*field, grid, options, extentsOf(*field, grid, options, serial));
  EXPECT_EQ(trees.inside(), 0U);
  int advances = 0;
  for (; !trees.isDone(); ++advances)
  {
    trees.advance(serial);
    EXPECT_GT(trees.inside(), 0U) << advances;
  }
  EXPECT_EQ(advances, 3);
}

TEST(VoxelTrees, ParentsAreInsideFromHalfOfTheirVoxelsOn)
{
  for (int inside = 0; inside <= 8; ++inside)
  {
    VoxelTreeBuilder builder(1, {2, 2, 2});
    const VoxelTree tree = builder.build([](const VoxelCube&) { return false; },
      [inside](const VoxelCube& cube)
      {
        const Eigen::Vector3i& at = cube.index;
        return VoxelState{0, at[0] + 2 * at[1] + 4 * at[2] < inside, 0};
      });
    ASSERT_EQ(tree.size(), 9u);
    EXPECT_EQ(tree.inside[0] != 0, inside >= 4) << inside;
  }
}

TEST(VoxelTrees, LevelsAndParentsAgree)
{
  const auto field = fieldOf(icosphere(3));
  SerialExecutor serial;
  for (const VoxelTree& tree : treesOf(*field, gridOf(50, 40, 33), {}, serial))
  {
    std::size_t first = 0, count = 1;
    for (int level = 0; level < tree.levels; ++level)
    {
      std::size_t parents = 0;
      for (std::size_t vertex = first; vertex < first + count; ++vertex)
      {
        parents += vertex < tree.isParent.size() && tree.isParent[vertex];
      }
      first += count;
      count = 8 * parents;
    }
    EXPECT_EQ(count, 0u);
    EXPECT_EQ(first, tree.size());
    EXPECT_EQ(tree.inside.size(), tree.size());
    EXPECT_EQ(tree.isBeyond.size(), tree.size());
    EXPECT_LT(tree.isParent.size(), tree.size()) << "the last level is left out";
    EXPECT_TRUE(tree.isParent.empty() || tree.levels > 1);
  }
}

TEST(VoxelTrees, DoNotDependOnThreads)
{
  const Grid grid = gridOf(70, 60, 50);
  for (const auto& field : {fieldOf(icosphere(3)), fieldOf(icosphere(3).part(0, 900))})
  {
    SerialExecutor serial;
    VoxelTreeOptions options;
    options.tolerance = 0.01;
    const std::vector<VoxelTree> one = treesOf(*field, grid, options, serial);
    ShuffledThreads threads(3);
    const std::vector<VoxelTree> several = treesOf(*field, grid, options, threads);
    for (std::size_t n = 0; n < one.size(); ++n)
    {
      EXPECT_TRUE(one[n].values == several[n].values && one[n].inside == several[n].inside &&
                  one[n].isParent == several[n].isParent && one[n].isBeyond == several[n].isBeyond);
    }
  }
}

TEST(VoxelTrees, AreInterrupted)
{
  const Grid grid = gridOf(70, 60, 50);
  for (const auto& field : {fieldOf(icosphere(3)), fieldOf(icosphere(3).part(0, 900))})
  {
    const VoxelTreeOptions options;
    for (int runs = 0; runs < 2; ++runs)
    {
      Interruption executor(runs);
      VoxelTrees trees(*field, grid, options, extentsOf(*field, grid, options, executor));
      EXPECT_THROW(trees.advance(executor), Interrupted);
    }
  }
}

} // namespace
