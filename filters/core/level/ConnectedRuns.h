// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/DisjointSets.h"
#include "base/Executor.h"
#include "level/LevelEdges.h"

#include <cstddef>
#include <vector>

namespace winding
{

/// The runs of samples with one value in the rows of a grid, and the sets that are connected along
/// its axes. Runs have indices, in the order of rows and along each. Time: n log n in the runs and
/// rows.
class ConnectedRuns
{
public:
  /// Takes runs with value `value` of all rows. Throws Interrupted.
  ConnectedRuns(
    const Grid& grid, const LevelEdges::RowRuns& rowRuns, int value, Executor& executor);

  std::size_t size() const { return runs_.size(); }

  /// Returns the number of sets.
  std::size_t sets() const;

  /// Returns the number of sets that have at most `most` samples.
  std::size_t setsUpTo(std::size_t most) const;

  /// Returns the index of the first run of a row.
  std::size_t firstOf(int j, int k) const { return starts_[this->rowOf(j, k)]; }

  /// Returns the index of the first run of the set of a run.
  std::size_t setOf(std::size_t run) const
  {
    return static_cast<std::size_t>(sets_.find(static_cast<std::int32_t>(run)));
  }

  /// Returns whether the set of each run has a sample at the border of the grid.
  std::vector<char> reachBorder() const;

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

  DisjointSets findRuns(const LevelEdges::RowRuns& rowRuns, int value, Executor& executor);
  void uniteLayer(int k);
  void unite(std::size_t a, std::size_t b);

  Eigen::Vector3i dimensions_;
  std::vector<Run> runs_;
  std::vector<std::size_t> starts_; ///< first run of each row, and one behind the last
  mutable DisjointSets sets_;
};

/// Returns the rows of edges, which must outlive them.
inline LevelEdges::RowRuns rowsOf(const LevelEdges& edges)
{
  return [&edges](int j, int k, std::vector<RowRun>& runs)
  {
    edges.findRuns(j, k, runs);
  };
}

} // namespace winding
