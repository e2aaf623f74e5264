// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/FieldOutput.h"
#include "base/Lazy.h"
#include "base/Views.h"
#include "rays/RayCounter.h"
#include "source/Surface.h"

#include <atomic>
#include <memory>

namespace winding
{

class ClearCells;
class TriangleColumns;

/// How triangles lie across rays along x, in the box of all of them.
struct RaysThroughTriangles
{
  double layers = 0; ///< triangles on a line along x, on average
  /// The sums of the longer and the shorter sides of the triangles' own boxes, as parts of the box.
  double lengths = 0, widths = 0;
};

/**
 * The exact integer winding numbers of a closed chain of triangles at scattered samples: the sum of
 * the signs of the crossings of a ray from the sample along +x. RowCrossings does the same on
 * grids.
 *
 * Where there are many samples, most lie in cells that no triangle reaches, and samples of a cell
 * share one ray (ClearCells.h).
 *
 * Seen along the rays, samples are points and triangles are triangles in the plane of y and z. Both
 * are put into columns, cells of a grid over the samples in that plane; a triangle goes into the
 * columns that it overlaps, not into all that its box overlaps. Columns that still hold many of
 * both are divided again, by a grid over their own samples: so it matters little how unevenly
 * either is distributed, and needles cost what they cross. Samples with the same y and z, such as
 * on a line along x, are sorted along x, and each triangle is searched for among them.
 *
 * Guaranteed: (1) every value is an integer, and the right one for all samples off the chain; (2) a
 * sample on the chain gets one of the values that occur around it, chosen by the same rule
 * everywhere (sideOfPlane()); (3) a value depends on the chain and the sample only, not on other
 * samples, the executor or its threads. Samples that are NaN or infinite get NaN. For chains larger
 * than 1e150 sample coordinates below 1e-150 of that leave the range of the predicates.
 *
 * The time is linear in triangles and samples, and in the pairs of both that are near to each other
 * in that plane. Most pairs may be near where triangles overlap each other very often, as in a
 * thousand solids through one another, and a direct sum may be faster there. This is even more so
 * for samples that crowd round a place, each half as far from it as the last: a division takes off
 * only a few of them.
 *
 * The executor gets tasks of some ten milliseconds, however the samples are distributed: a task
 * that turns out to be longer is given up, and its column is divided into tasks. So interruption is
 * answered soon. A line of samples along x is one task; a million of them take a tenth of a second.
 *
 * Where few samples are asked for again and again, the triangles stay sorted by columns from the
 * second time on (TriangleColumns.h), so that a sample takes some microseconds.
 *
 * The memory is 44 bytes per sample, and 40 more for each sample of a column that is divided; up to
 * 140 bytes per triangle, and that again for each triangle of a column that is divided: lists of
 * the triangles in columns are made for as many columns at a time as that allows. A thread takes up
 * to 20 MB.
 */
class PointCrossings
{
public:
  /// Keeps references; takes no time.
  explicit PointCrossings(const Surface& surface);

  /// A chain of two lists of triangles over common vertices: a surface and its cap. `bounds` holds
  /// all vertices. References are kept to all four.
  PointCrossings(const std::vector<Eigen::Vector3d>& vertices, const ChainView& triangles,
    const ChainView& cap, const Bounds& bounds);
  ~PointCrossings();

  /// Weighs the work of evaluate() for `samples` samples spread over the triangles' box, as
  /// weightOfFarField() does. The first call walks over the triangles.
  double weight(std::size_t samples) const;

  /// Returns the expected memory of evaluate(), the triangles included.
  std::size_t bytes(std::size_t samples) const;

  /// Evaluates scattered samples. Divides the executor's share of progress and restores it in the
  /// end. Throws Interrupted.
  void evaluate(const VectorsView& samples, const FieldOutput& output, Executor& executor) const;

private:
  bool isWorthClearing(std::size_t samples) const;
  void cast(const VectorsView& samples, const FieldOutput& output, const ClearCells* clear,
    Executor& executor) const;
  const TriangleColumns* columnsForFew(
    const RayCounter& counter, double scale, std::size_t rays, Executor& executor) const;

  CrossedChain chain_;
  const Bounds& bounds_;
  Lazy<RaysThroughTriangles> rays_;
  mutable std::atomic<bool> wereFewAsked_{false};
  Lazy<std::unique_ptr<const TriangleColumns>> columns_;
};

} // namespace winding
