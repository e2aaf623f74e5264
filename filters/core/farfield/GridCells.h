// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "farfield/TargetCells.h"
#include "source/Grid.h"

#include <cstdint>

namespace winding
{

/// Takes the values of a grid's samples, a piece of a row at a time, on several threads at once.
class RowSink
{
public:
  virtual ~RowSink() = default;

  /// Takes the values of samples (i, j, k) … (i + count − 1, j, k). `isSuspect` says which of them
  /// lie on a source; it is null if none is known to.
  virtual void row(
    int i, int j, int k, std::size_t count, const float* values, const bool* isSuspect) const = 0;
};

/**
 * Returns whether a far field may have a grid: the powers of a sample's distance from the sources,
 * in lengths of these, have to stay within the range of single precision. Grids that reach farther
 * are for direct sums. The scale is the sources' (UnitScale.h).
 */
bool isInReachOfSingles(const Grid& grid, const Bounds& sources, double scale);

/**
 * The samples of a grid as a hierarchy of blocks: 8³ samples or, where voxels are not cubes, about
 * as many in a block as cubic as can be; eight of these make the next larger cell, and so on. Cells
 * are anchored at the grid's first sample, so the cells of an extent are the very cells of the
 * whole.
 */
class GridCells final : public TargetCells
{
public:
  /// Keeps a reference to the grid. scale: the sources' scale.
  GridCells(const Grid& grid, const Extent& extent, double scale, int order);

  void setSink(const RowSink& sink) { sink_ = &sink; }

  /// The level whose cells make good tasks, also if all cells in a row along x make one task: there
  /// are enough of these for some threads. It depends on the whole grid only, not on the extent.
  int taskLevel() const { return taskLevel_; }

  /// The number of samples along an axis of a cell of a level.
  std::int64_t sizeOf(int level, int axis) const;

  /// The part of a cell that is in the extent.
  Extent samplesOf(const TargetCell& cell) const;

  TargetCell root() const override;
  int childrenOf(const TargetCell& cell, Child (&children)[8]) const override;
  void fill(const TargetCell& cell, std::size_t first, TargetBlock& block) const override;
  void store(const TargetCell& cell, std::size_t first, std::size_t count, const float* values,
    const bool* isSuspect) const override;
  std::size_t rowsOf(const TargetCell& cell) const override;
  void storePolynomial(const TargetCell& cell, int order, const float* coefficients) const override;

private:
  Extent samplesOf(const TargetCell& cell, const Extent& extent) const;
  TargetCell cellAt(int level, const Eigen::Vector3i& index) const;
  void fillOffsets(const TargetCell& cell, int first, std::size_t count, float* offsets) const;
  float offsetIn(const TargetCell& cell, int axis, int sample) const;

  const Grid& grid_;
  Extent extent_;
  double scale_;
  Eigen::Vector3d spacing_;   ///< scaled
  Eigen::Vector3i exponents_; ///< block sizes, as exponents of 2
  int taskLevel_;
  const RowSink* sink_ = nullptr;
};

} // namespace winding
