// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/FarField.h"

#include "base/FieldOutput.h"
#include "base/FlushToZero.h"
#include "base/Progress.h"
#include "farfield/Expansions.h"
#include "farfield/FarFieldGradient.h"
#include "farfield/FarFieldTraversal.h"
#include "farfield/PointCells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace winding
{

namespace
{

/// Puts the values of rows where they belong in the arrays of an extent.
class ArraySink final : public RowSink
{
public:
  ArraySink(const Extent& extent, const FieldOutput& output)
    : extent_(extent)
    , output_(output)
  {
  }

  void row(int i, int j, int k, std::size_t count, const float* values, const bool*) const override
  {
    output_.write(values, sampleNumber(extent_, i, j, k), count);
  }

private:
  Extent extent_;
  FieldOutput output_;
};

/// Writes the values of scattered samples to arrays.
class ArrayPointSink final : public PointSink
{
public:
  explicit ArrayPointSink(const FieldOutput& output)
    : output_(output)
  {
  }

  void askFor(std::size_t sample) const override { output_.askFor(sample); }
  void point(std::size_t sample, double value, bool) const override
  {
    output_.write(&value, sample, 1);
  }

private:
  FieldOutput output_;
};

} // namespace

FarField::FarField(
  std::unique_ptr<FarFieldSources> sources, const FarFieldAccuracy& accuracy, Executor& executor)
  : tree_(std::move(sources), accuracy, executor)
{
}

std::vector<FarFieldTask> FarField::tasks(
  const TargetCells& cells, int level, FarFieldWork* work) const
{
  const FlushToZero flush;
  std::vector<FarFieldTask> tasks;
  const FarFieldWork done = FarFieldTraversal(tree_, cells).collect(level, tasks);
  if (work)
  {
    *work += done;
  }
  return tasks;
}

FarFieldWork FarField::evaluate(
  const TargetCells& cells, const FarFieldTask& task, bool watching) const
{
  const FlushToZero flush;
  return FarFieldTraversal(tree_, cells).evaluate(task, watching);
}

void FarField::evaluateAll(const TargetCells& cells, int taskLevel, bool watching,
  Executor& executor, FarFieldWork* work) const
{
  FarFieldWork total;
  const std::vector<FarFieldTask> all = this->tasks(cells, taskLevel, &total);

  // Each task has its own of both, so that none waits for another.
  std::vector<FarFieldWork> parts(all.size());
  std::vector<std::vector<TargetCell>> toWhole(all.size());
  Progress progress(executor);
  const double middle = cells.isRegular() ? 1 : 0.9;
  progress.set(0, middle);
  executor.run(all.size(),
    [&](std::size_t task)
    {
      const FlushToZero flush;
      FarFieldTraversal traversal(tree_, cells);
      parts[task] = traversal.evaluate(all[task], watching, &toWhole[task]);
    });

  progress.set(middle, 1);
  this->evaluateWhole(cells, toWhole, watching, executor, parts);
  if (work)
  {
    *work += std::accumulate(parts.begin(), parts.end(), total,
      [](FarFieldWork sum, const FarFieldWork& part) { return sum += part; });
  }
}

/// Gives the samples of the cells that tasks have left the sum of the whole sources, and appends
/// the work done.
void FarField::evaluateWhole(const TargetCells& cells,
  const std::vector<std::vector<TargetCell>>& toWhole, bool watching, Executor& executor,
  std::vector<FarFieldWork>& work) const
{
  std::vector<TargetCell> all;
  for (const std::vector<TargetCell>& ofTask : toWhole)
  {
    all.insert(all.end(), ofTask.begin(), ofTask.end());
  }
  // Each cell has a sample at least, and few more.
  constexpr std::size_t cellsPerBlock = SampleBlock::capacity;
  const std::size_t blocks = (all.size() + cellsPerBlock - 1) / cellsPerBlock;
  const std::size_t done = work.size();
  work.resize(done + blocks);
  executor.run(blocks,
    [&](std::size_t block)
    {
      const FlushToZero flush;
      const TargetCell* const first = all.data() + block * cellsPerBlock;
      const TargetCell* const end = all.data() + all.size();
      work[done + block] = FarFieldTraversal(tree_, cells)
                             .evaluateWhole(first, std::min(first + cellsPerBlock, end), watching);
    });
}

void FarField::evaluate(const Grid& grid, const Extent& extent, const FieldOutput& output,
  Executor& executor, FarFieldWork* work) const
{
  if (sampleCount(extent) == 0)
  {
    return;
  }
  GridCells cells(grid, extent, this->scale(), this->order());
  const ArraySink sink(extent, output);
  cells.setSink(sink);
  this->evaluateAll(cells, cells.taskLevel(), false, executor, work);
}

PointCells FarField::cellsOf(
  const VectorsView& samples, const PointSink* sink, Executor& executor) const
{
  // Samples farther away than this, in units of the sources' size, would make the cells of all
  // others too large.
  constexpr double farthest = 64;
  const double radius = tree_.empty() ? 1 : tree_.moments.criteria.radius[0];
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(farthest * std::max(1.0, radius));
  const Eigen::AlignedBox3d region(tree_.moments.origin - reach, tree_.moments.origin + reach);
  return {samples, region, this->scale(), this->order(), sink, executor};
}

void FarField::evaluate(const VectorsView& samples, const FieldOutput& output, Executor& executor,
  FarFieldWork* work) const
{
  this->evaluate(samples, ArrayPointSink(output), false, executor, work);
}

void FarField::evaluate(const VectorsView& samples, const PointSink& sink, bool watching,
  Executor& executor, FarFieldWork* work) const
{
  const PointCells cells = this->cellsOf(samples, &sink, executor);
  for (const std::uint32_t number : cells.others())
  {
    sink.point(number, this->valueFarAway(samples[number]), false);
  }
  if (!cells.empty())
  {
    this->evaluateAll(cells, cells.taskLevel(), watching, executor, work);
  }
}

void FarField::gradient(const VectorsView& samples, double* gradients, Executor& executor) const
{
  Progress progress(executor);
  progress.set(0, 0.1);
  const PointCells cells = this->cellsOf(samples, nullptr, executor);
  progress.set(0.1, 1);
  const FarFieldGradient gradient(tree_, cells, gradients);
  const std::vector<FarFieldTask> all =
    cells.empty() ? std::vector<FarFieldTask>() : this->tasks(cells, cells.taskLevel());
  for (const std::uint32_t number : cells.others())
  {
    gradient.evaluateFarAway(samples[number], number);
  }
  executor.run(all.size(), [&](std::size_t task) { gradient.evaluate(all[task]); });
}

/// The moments of the root stand for all sources, since the sample is far away from all of them.
double FarField::valueFarAway(const Eigen::Vector3d& sample) const
{
  if (!sample.allFinite())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (tree_.empty())
  {
    return 0;
  }
  const double inverse = 1.0 / tree_.moments.criteria.radius[0];
  const float* const root = tree_.moments.of(0);
  return inverse * momentsAt(this->order(), {root, root + coefficientCount(this->order())},
                     tree_.offsetFromRoot(sample));
}

} // namespace winding
