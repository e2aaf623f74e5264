// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "source/Grid.h"
#include "source/Surface.h"

#include <functional>
#include <memory>
#include <vector>

namespace winding
{

/// Samples begin … end − 1 of a row, all with the same value.
struct RowRun
{
  int begin, end;
  int value;
};

/// The rows of a layer in bands of rowsPerBand rows each; band 0 begins with firstRow.
struct RowBands
{
  int firstRow; ///< the first row of an extent, or a row before it
  int rowsPerBand;

  std::size_t bandOf(int row) const
  {
    return static_cast<std::size_t>((row - firstRow) / rowsPerBand);
  }
  int firstRowOf(std::size_t band) const { return firstRow + static_cast<int>(band) * rowsPerBand; }

  /// The last row of a band that is in an extent. (A band may reach beyond all integers.)
  int lastRowIn(const Extent& extent, std::size_t band) const
  {
    return static_cast<int>(std::min<long long>(
      extent[3], static_cast<long long>(this->firstRowOf(band)) + rowsPerBand - 1));
  }
  std::size_t countIn(const Extent& extent) const { return this->bandOf(extent[3]) + 1; }
};

/**
 * The exact integer winding numbers of closed chains of triangles on a grid, a whole row at a time.
 *
 * A row is a line of samples along x. Walking along it, w changes only where the row crosses the
 * chain, by the sign of the crossing: the crossings of a row, found once, serve all of its samples.
 * Nothing is computed at the samples themselves; a run of equal values is filled.
 *
 * Guaranteed: (1) every value is an integer, and the right one for all samples off the chain; (2) a
 * sample on the chain gets the neighbouring value that sideOfPlane() steps to: one of those that
 * occur around it, chosen by the same rule everywhere; (3) values depend on the grid as a whole,
 * never on the extent, the executor or its threads. The chain is taken in units of the grid, which
 * rounds the coordinates of its vertices once and for all, to 2⁻⁵² of their distance from the
 * grid's first sample; grids whose voxels are smaller than 1e-150 of that distance leave the range
 * of the predicates.
 *
 * The time is linear in the triangles, the crossings and the runs. The memory is 4 bytes per
 * triangle, layer and band that it reaches, 8 per layer and band, and some 50 per sample of the
 * bands at work; 24 bytes per vertex unless most triangles lie between the rows; and 8 per vertex
 * and 4 per triangle that reaches a row while the triangles are distributed to the bands.
 */
class RowCrossings
{
public:
  /// The work for row (j, k), called once for each row, from the executor's threads. The runs cover
  /// the extent's range of x without gaps.
  using RowWork = std::function<void(int j, int k, const std::vector<RowRun>& runs)>;

  /// A chain is two lists of triangles over common vertices: a surface and its cap. References are
  /// kept.
  RowCrossings(const std::vector<Eigen::Vector3d>& vertices, const ChainView& triangles,
    const ChainView& cap = noTriangles());

  /// The data that the rows of an extent need, made once for all of them. The object that is
  /// returned refers to this one. Throws Interrupted.
  class OnGrid;
  std::unique_ptr<const OnGrid> on(
    const Grid& grid, const Extent& extent, const RowBands& rows, Executor& executor) const;

  /// The work for a band of layer k, called once for each, from the executor's threads.
  using BlockWork = std::function<void(const OnGrid& onGrid, int k, std::size_t band)>;

  /// Calls work for all bands of an extent. A band has about samplesPerBlock samples, and at least
  /// a row. Throws Interrupted.
  void evaluateBlocks(const Grid& grid, const Extent& extent, std::size_t samplesPerBlock,
    const BlockWork& work, Executor& executor) const;

  /// Calls work for all rows of an extent, as evaluateBlocks() comes to them.
  void evaluate(const Grid& grid, const Extent& extent, std::size_t samplesPerBlock,
    const RowWork& work, Executor& executor) const;

private:
  static const TriangleList& noTriangles();

  /// The layers of an extent whose data is made at once, and less than 1 for a part of a layer. All
  /// of them where the data stays within about half a gigabyte.
  double layersAtATime(const Grid& grid, const Extent& extent, const RowBands& rows) const;

  const std::vector<Eigen::Vector3d>& vertices_;
  ChainView triangles_, cap_;
};

/// The rows of an extent, band by band, in any order and from any thread.
class RowCrossings::OnGrid
{
public:
  virtual ~OnGrid() = default;

  /// Calls work for the rows of a band of layer k that are in the extent.
  virtual void evaluate(int k, std::size_t band, const RowWork& work) const = 0;
};

} // namespace winding
