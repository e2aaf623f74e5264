// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/FilledCavities.h"

#include "base/DisjointSets.h"
#include "level/CombinedRoots.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace winding
{

namespace
{

/// The runs of outside samples of a grid's rows, and which of them are cavities.
class OutsideRuns
{
public:
  OutsideRuns(const LevelEdges& solid, const Grid& grid, Executor& executor)
    : dimensions_(grid.dimensions)
    , sets_(this->findRuns(solid, executor))
  {
    // Sets are united one after the other. Between layers the executor looks for interrupts.
    for (int k = 0; k < dimensions_[2]; ++k)
    {
      executor.runBriefly(1, [&](std::size_t) { this->uniteLayer(k); });
    }
    this->findCavities();
  }

  /// The number of cavities.
  std::size_t cavities() const { return cavities_; }

  /// Sets the runs of a row with value 0 to 1 where they are in cavities, and joins equal ones.
  void fill(int j, int k, std::vector<RowRun>& runs) const
  {
    std::size_t outside = starts_[this->rowOf(j, k)];
    std::size_t last = 0;
    for (std::size_t n = 0; n < runs.size(); ++n)
    {
      RowRun run = runs[n];
      if (run.value == 0)
      {
        run.value = isCavity_[outside++] != 0;
      }
      if (n > 0 && runs[last].value == run.value)
      {
        runs[last].end = run.end;
      }
      else
      {
        last = n > 0 ? last + 1 : 0;
        runs[last] = run;
      }
    }
    runs.resize(last + 1);
  }

private:
  struct Run
  {
    int begin, end;
  };

  std::size_t rowOf(int j, int k) const
  {
    return static_cast<std::size_t>(k) * static_cast<std::size_t>(dimensions_[1]) +
           static_cast<std::size_t>(j);
  }

  /// Finds all runs, first how many there are, and returns a set for each.
  DisjointSets findRuns(const LevelEdges& solid, Executor& executor)
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
            solid.findRuns(j, static_cast<int>(layer), runs);
            visit(this->rowOf(j, static_cast<int>(layer)), runs);
          }
        },
        executor);
    };
    forRuns(
      [this](std::size_t row, const std::vector<RowRun>& runs)
      {
        starts_[row + 1] = static_cast<std::size_t>(std::count_if(
          runs.begin(), runs.end(), [](const RowRun& run) { return run.value == 0; }));
      });
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    runs_.resize(starts_.back());
    forRuns(
      [this](std::size_t row, const std::vector<RowRun>& runs)
      {
        std::size_t next = starts_[row];
        for (const RowRun& run : runs)
        {
          if (run.value == 0)
          {
            runs_[next++] = {run.begin, run.end};
          }
        }
      });
    return DisjointSets(runs_.size());
  }

  /// Unites the runs of a layer with their neighbours in it and in the layer before.
  void uniteLayer(int k)
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
  void unite(std::size_t a, std::size_t b)
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

  void findCavities()
  {
    std::vector<char> isReached(runs_.size(), 0);
    const auto setOf = [this](std::size_t run)
    {
      return static_cast<std::size_t>(sets_.find(static_cast<std::int32_t>(run)));
    };
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
            isReached[setOf(n)] = 1;
          }
        }
      }
    }
    isCavity_.resize(runs_.size());
    for (std::size_t n = 0; n < runs_.size(); ++n)
    {
      isCavity_[n] = isReached[setOf(n)] == 0;
      cavities_ += isCavity_[n] != 0 && setOf(n) == n;
    }
  }

  Eigen::Vector3i dimensions_;
  std::vector<Run> runs_;
  std::vector<std::size_t> starts_; ///< first run of each row, and one behind the last
  DisjointSets sets_;
  std::vector<char> isCavity_;
  std::size_t cavities_ = 0;
};

} // namespace

FilledCavities::FilledCavities(
  const LevelEdges& solid, const EdgeRoots& solidRoots, const Grid& grid, Executor& executor)
  : count(0)
  , edges(
      [&]
      {
        const OutsideRuns outside(solid, grid, executor);
        count = outside.cavities();
        const auto rowRuns = [&](int j, int k, std::vector<RowRun>& runs)
        {
          solid.findRuns(j, k, runs);
          outside.fill(j, k, runs);
        };
        return LevelEdges(
          grid, solid.border() > 0, 1, [&](int, int) { return rowRuns; }, executor);
      }())
  // All edges are the solid's own, so these are the roots of a union of one.
  , roots(CombinedRoots(edges, {{&solid, &solidRoots}}, BooleanOperation::unite, executor).roots)
{
}

double FilledCavities::bytesFor(const Grid& grid, double edges)
{
  const double rows =
    static_cast<double>(grid.dimensions[1]) * static_cast<double>(grid.dimensions[2]);
  // A row has one run more than it has cavities and solids between them.
  constexpr double perRun = 2 * sizeof(int) + sizeof(std::int32_t) + 2 * sizeof(char);
  return rows * sizeof(std::size_t) + (rows + edges) * perRun;
}

} // namespace winding
