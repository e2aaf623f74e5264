// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "base/Executor.h"
#include "rays/RayCounter.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace winding
{

/**
 * Cells of a grid over a closed chain that no triangle reaches. The winding number is the same
 * everywhere in such a cell, and in a run of them along x: one ray gives it for all samples there,
 * which are most samples. Outside of the grid it is 0.
 *
 * A triangle reaches the cells that its box overlaps; a triangle over several cells is halved for
 * that until its parts are small, and boxes are widened by the rounding of that. So a sample in a
 * clear cell is off the chain.
 */
class ClearCells
{
public:
  /// `bounds` holds all vertices, and is more than one point. Takes time in proportion to the
  /// triangles and to the cells that they reach; 5 bytes per cell while it runs, and 4 later.
  /// Throws Interrupted.
  ClearCells(
    const CrossedChain& chain, const Bounds& bounds, std::size_t wantedCells, Executor& executor);

  /// A place in each run of clear cells.
  const std::vector<Eigen::Vector3d>& places() const { return places_; }

  /// Sets the winding numbers of the places.
  void setWindings(std::vector<double> windings) { windings_ = std::move(windings); }

  /// The winding number of a sample, which must be finite, outside of the grid or in a clear cell;
  /// of no other. To be called after setWindings().
  std::optional<double> windingAt(const Eigen::Vector3d& sample) const
  {
    if (!bounds_.contains(sample))
    {
      return 0;
    }
    const std::int32_t run = runs_[this->numberOf(this->cellOf(sample))];
    return run == reached ? std::nullopt
                          : std::make_optional(windings_[static_cast<std::size_t>(run)]);
  }

private:
  /// In place of the number of a run.
  static constexpr std::int32_t reached = std::numeric_limits<std::int32_t>::min();

  class Marks;

  /// The cell of a place in the box, or of the cells the nearest to a place outside it. No rounding
  /// changes the order of places along an axis.
  Eigen::Array3i cellOf(const Eigen::Vector3d& place) const
  {
    const Eigen::Array3d at = (place - bounds_.min()).array() * cellsPerLength_;
    return at.max(0.0).min(dimensions_.cast<double>() - 1).cast<int>();
  }
  std::size_t numberOf(const Eigen::Array3i& cell) const
  {
    return static_cast<std::size_t>(
      (cell[2] * dimensions_[1] + cell[1]) * dimensions_[0] + cell[0]);
  }
  void findRuns(const Marks& marks);

  Bounds bounds_;
  Eigen::Vector3d margin_; ///< more than the roundings of middles of sides, and of cellOf()
  Eigen::Array3i dimensions_;
  Eigen::Array3d cellsPerLength_;  ///< 0 along an axis with a single cell
  std::vector<std::int32_t> runs_; ///< by cell: the number of its run
  std::vector<Eigen::Vector3d> places_;
  std::vector<double> windings_;
};

} // namespace winding
