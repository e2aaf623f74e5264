// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/ConnectedRuns.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace winding
{

ConnectedRuns::ConnectedRuns(
  const Grid& grid, const LevelEdges::RowRuns& rowRuns, int value, Executor& executor)
  : dimensions_(grid.dimensions)
  , sets_(this->findRuns(rowRuns, value, executor))
{
  // Sets are united one after the other. Between layers the executor looks for interrupts.
  for (int k = 0; k < dimensions_[2]; ++k)
  {
    executor.runBriefly(1, [&](std::size_t) { this->uniteLayer(k); });
  }
}

/// Finds all runs, first how many there are, and returns a set for each.
DisjointSets ConnectedRuns::findRuns(
  const LevelEdges::RowRuns& rowRuns, int value, Executor& executor)
{
  const auto layers = static_cast<std::size_t>(dimensions_[2]);
  starts_.assign(this->rowOf(0, dimensions_[2]) + 1, 0);
  const auto forRuns = [&](const auto& visit)
  {
    runBlocks(
      layers, 1,
      [&](std::size_t layer, std::size_t, std::size_t)
      {
        std::vector<RowRun> runs;
        for (int j = 0; j < dimensions_[1]; ++j)
        {
          rowRuns(j, static_cast<int>(layer), runs);
          visit(this->rowOf(j, static_cast<int>(layer)), runs);
        }
      },
      executor);
  };
  forRuns(
    [&](std::size_t row, const std::vector<RowRun>& runs)
    {
      starts_[row + 1] = static_cast<std::size_t>(std::count_if(
        runs.begin(), runs.end(), [value](const RowRun& run) { return run.value == value; }));
    });
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  runs_.resize(starts_.back());
  forRuns(
    [&](std::size_t row, const std::vector<RowRun>& runs)
    {
      std::size_t next = starts_[row];
      for (const RowRun& run : runs)
      {
        if (run.value == value)
        {
          runs_[next++] = {run.begin, run.end};
        }
      }
    });
  return DisjointSets(runs_.size());
}

/// Unites the runs of a layer with their neighbours in it and in the layer before.
void ConnectedRuns::uniteLayer(int k)
{
  for (int j = 0; j < dimensions_[1]; ++j)
  {
    if (j > 0)
    {
      this->unite(this->rowOf(j, k), this->rowOf(j - 1, k));
    }
    if (k > 0)
    {
      this->unite(this->rowOf(j, k), this->rowOf(j, k - 1));
    }
  }
}

/// Unites the runs of two rows that have samples next to each other.
void ConnectedRuns::unite(std::size_t a, std::size_t b)
{
  for (std::size_t m = starts_[a], n = starts_[b]; m < starts_[a + 1] && n < starts_[b + 1];)
  {
    if (std::max(runs_[m].begin, runs_[n].begin) < std::min(runs_[m].end, runs_[n].end))
    {
      sets_.unite(static_cast<std::int32_t>(m), static_cast<std::int32_t>(n));
    }
    ++(runs_[m].end < runs_[n].end ? m : n);
  }
}

std::size_t ConnectedRuns::sets() const
{
  std::size_t count = 0;
  for (std::size_t n = 0; n < runs_.size(); ++n)
  {
    count += this->setOf(n) == n;
  }
  return count;
}

std::size_t ConnectedRuns::setsUpTo(std::size_t most) const
{
  std::vector<std::size_t> samples(runs_.size());
  for (std::size_t n = 0; n < runs_.size(); ++n)
  {
    samples[this->setOf(n)] += static_cast<std::size_t>(runs_[n].end - runs_[n].begin);
  }
  return static_cast<std::size_t>(std::count_if(samples.begin(), samples.end(),
    [most](std::size_t count) { return count > 0 && count <= most; }));
}

std::vector<char> ConnectedRuns::reachBorder() const
{
  std::vector<char> areReached(runs_.size(), 0);
  for (int k = 0; k < dimensions_[2]; ++k)
  {
    for (int j = 0; j < dimensions_[1]; ++j)
    {
      const bool isAtBorder =
        j == 0 || j == dimensions_[1] - 1 || k == 0 || k == dimensions_[2] - 1;
      const std::size_t row = this->rowOf(j, k);
      for (std::size_t n = starts_[row]; n < starts_[row + 1]; ++n)
      {
        if (isAtBorder || runs_[n].begin == 0 || runs_[n].end == dimensions_[0])
        {
          areReached[this->setOf(n)] = 1;
        }
      }
    }
  }
  for (std::size_t n = 0; n < runs_.size(); ++n)
  {
    areReached[n] = areReached[this->setOf(n)]; // the first of a set comes first
  }
  return areReached;
}

} // namespace winding
