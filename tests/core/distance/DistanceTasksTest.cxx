// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "distance/DistanceTree.h"
#include "distance/GridDistances.h"
#include "distance/NearestKernels.h"
#include "distance/SampleDistances.h"

#include "support/FieldDistances.h"
#include "support/Fields.h"
#include "support/Grids.h"
#include "support/Interruption.h"
#include "support/Serial.h"

#include <gtest/gtest.h>

#include <algorithm>

/**
 * How distances are cut into tasks, what is shown of them as progress, and how they are
 * interrupted.
 */
namespace
{

using namespace shapes;
using winding::Extent;
using winding::Grid;
using winding::sampleCount;
using winding::sampleIndex;
using winding::sampleNumber;

/// Counts tasks.
class CountingTasks final : public winding::Executor
{
public:
  void run(std::size_t count, const std::function<void(std::size_t)>& work) override
  {
    tasks += count;
    winding::SerialExecutor().run(count, work);
  }
  std::size_t tasks = 0;
};

/// Cubic voxels around and in a sphere of about unit size.
Grid gridOverASphere()
{
  return gridAround({Point(-1.6, -1.5, -1.4), Point(1.3, 1.5, 1.7)}, {11, 13, 12});
}

} // namespace

TEST(DistanceTasks, InterruptionIsToldWhereverItCame)
{
  const Grid grid = gridOverASphere();
  int runs = 0;
  for (bool isOver = false; !isOver; ++runs)
  {
    const auto field = fieldOf(icosphere(2));
    Interruption executor(runs);
    Distances result(sampleCount(grid.wholeExtent()));
    const bool isComplete = isCompleted(
      [&] { field->evaluate(grid, grid.wholeExtent(), result.output(infinite), executor); });
    isOver = !executor.cameToPass();
    EXPECT_EQ(isComplete, isOver) << runs;
    // An interruption leaves the next evaluation as good as any.
    EXPECT_EQ(evaluate(*field, grid).distances, evaluate(*fieldOf(icosphere(2)), grid).distances);
  }
  EXPECT_GT(runs, 3) << "values, the tree in some steps, and distances";
}

TEST(DistanceTasks, AreSmallWhereEverythingIsAsNear)
{
  // All points are as near to all samples, and all samples are one block. Triangles would not do:
  // the few that lie deepest in their sphere are nearest everywhere about its centre.
  const winding::DistanceTree tree(clean(sphereCloud(80'000)), serial);
  Grid grid;
  grid.dimensions = {16, 16, 16};
  grid.spacing.setConstant(1e-18);
  grid.firstSample.setConstant(0);
  const Extent whole = grid.wholeExtent(), part = {3, 4, 9, 9, 15, 15};
  Distances all(sampleCount(whole)), some(sampleCount(part)), scattered(sampleCount(whole));
  const auto tasksFor = [&](const Extent& extent, Distances& result)
  {
    CountingTasks executor;
    const winding::FieldOutput output = result.output(infinite);
    winding::GridDistances(tree, grid, extent, output).evaluate(executor);
    return executor.tasks;
  };
  EXPECT_EQ(tasksFor(part, some), 1u);
  EXPECT_GT(tasksFor(whole, all), 1u);

  const std::vector<Point> samples = samplesOf(grid);
  CountingTasks executor;
  winding::evaluateDistances(tree, winding::VectorsView(samples[0].data(), samples.size()),
    scattered.output(infinite), executor);
  // The samples are sorted by two runs of one task each, then 64 tasks search for them, and leave
  // most of them to further tasks.
  EXPECT_GT(executor.tasks, 66u + 32u);

  for (std::size_t n = 0; n < all.distances.size(); ++n)
  {
    ASSERT_NEAR(all.distances[n], -1, 1e-14) << n;
    ASSERT_EQ(scattered.distances[n], all.distances[n]) << n;
  }
  for (std::size_t n = 0; n < some.distances.size(); ++n)
  {
    EXPECT_EQ(some.distances[n], all.distances[sampleNumber(whole, sampleIndex(part, n))]);
  }
}

TEST(DistanceTasks, OfEqualSamplesTakeNoLongerThanOfOne)
{
  // One by one they would take more than a minute, in a task that cannot be interrupted.
  const winding::DistanceTree tree(clean(sphereCloud(80'000)), serial);
  const std::vector<Point> samples(2'000'000, Point(0, 0, 0));
  Distances found(samples.size());
  winding::evaluateDistances(
    tree, winding::VectorsView(samples[0].data(), samples.size()), found.output(infinite), serial);
  EXPECT_NEAR(found.distances[0], -1, 1e-14);
  EXPECT_EQ(std::count(found.distances.begin(), found.distances.end(), found.distances[0]),
    static_cast<std::ptrdiff_t>(samples.size()));
}

TEST(DistanceTasks, OfEqualSamplesThatAreFewTakeNoLongerThanOfOne)
{
  const winding::DistanceTree tree(clean(sphereCloud(80'000)), serial);
  const std::vector<Point> samples(79'000, Point(0, 0, 0));
  Distances found(samples.size());
  CountingTasks executor;
  winding::evaluateDistances(tree, winding::VectorsView(samples[0].data(), samples.size()),
    found.output(infinite), executor);
  EXPECT_LE(executor.tasks, 74u) << "10 to sort, 64 to search, and none is left for cells";
  EXPECT_EQ(std::count(found.distances.begin(), found.distances.end(), found.distances[0]),
    static_cast<std::ptrdiff_t>(samples.size()));
}

TEST(DistanceTasks, SearchesAreInterruptedWhereverThatComes)
{
  const winding::DistanceTree tree(clean(icosphere(5)), serial);
  const std::vector<Point> samples = randomPoints(5000, -1, 1, 76);
  int runs = 0;
  for (bool isOver = false; !isOver; ++runs)
  {
    Interruption executor(runs);
    Distances found(samples.size());
    const winding::VectorsView view(samples[0].data(), samples.size());
    const bool isComplete = isCompleted(
      [&] { winding::evaluateDistances(tree, view, found.output(infinite), executor); });
    isOver = !executor.cameToPass();
    EXPECT_EQ(isComplete, isOver) << runs;
  }
  EXPECT_GT(runs, 2) << "sorting, and searches";
}

TEST(DistanceTasks, WorkThatTasksLeaveShowsNoProgressOnceMore)
{
  /// Counts the calls whose tasks show progress, and those whose tasks do not.
  class Counting final : public winding::Executor
  {
  public:
    void run(std::size_t count, const std::function<void(std::size_t)>& work) override
    {
      ++shown;
      winding::SerialExecutor().run(count, work);
    }
    void runBriefly(std::size_t count, const std::function<void(std::size_t)>& work) override
    {
      ++brief;
      winding::SerialExecutor().run(count, work);
    }
    int shown = 0, brief = 0;
  };
  // All points are as near to all of the grid: few of them are done in one go, many are not.
  Grid grid;
  grid.dimensions = {16, 16, 16};
  grid.spacing.setConstant(1e-18);
  grid.firstSample.setConstant(0);
  int brief[2];
  for (int i = 0; i < 2; ++i)
  {
    const Cloud cloud = sphereCloud(i == 0 ? 1000 : 80'000);
    winding::FieldOptions options;
    options.method = winding::Method::direct;
    options.pointAreaMethod = winding::PointAreaMethod::constant;
    options.pointArea = 1;
    const auto field = fieldOf(cloud, options);
    field->prepareDistances(serial);
    Counting executor;
    Distances result(sampleCount(grid.wholeExtent()));
    field->evaluate(grid, grid.wholeExtent(), result.output(infinite), executor);
    EXPECT_EQ(executor.shown, 2) << "values, and distances";
    brief[i] = executor.brief;
  }
  EXPECT_EQ(brief[0], 0);
  EXPECT_GT(brief[1], 0);
}

TEST(DistanceTasks, TreeIsMadeOnceAndBeforeIfAskedFor)
{
  /// Counts the calls of run().
  class Counting final : public winding::Executor
  {
  public:
    void run(std::size_t count, const std::function<void(std::size_t)>& work) override
    {
      ++runs;
      winding::SerialExecutor().run(count, work);
    }
    int runs = 0;
  };
  const auto field = fieldOf(icosphere(2));
  Counting preparing, again;
  field->prepareDistances(preparing);
  EXPECT_GT(preparing.runs, 1);
  field->prepareDistances(again);
  EXPECT_EQ(again.runs, 0);
  EXPECT_GT(field->expectedBytesOfDistances(1000), 320 * sizeof(winding::NearTriangle));
}
