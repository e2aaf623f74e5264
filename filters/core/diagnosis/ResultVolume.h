// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/BooleanOperation.h"
#include "diagnosis/Diagnosis.h"

#include <vector>

namespace winding
{

/**
 * The volume of an operation on closed surfaces, to compare a result with.
 *
 * Lines along the axes cross the operands, and later the result: one at random in each of 48 × 48
 * cells of each side of the grid, or of half as many as it has voxels along its longest side, and
 * fewer through long triangles. Only their difference is sampled: the volume of the result is
 * exact. A test of a line for each 16 voxels takes a fiftieth of the time of the result.
 */
class ResultVolume
{
public:
  ResultVolume(const Grid& grid, BooleanOperation operation);

  /// Adds the next operand. Nothing is known any more if it is open. Throws Interrupted.
  void add(const Diagnosis& operand, const InsideTest& isInside, Executor& executor);

  /// Returns whether there is anything to compare with.
  bool isKnown() const { return !lines_.empty(); }

  /// Gives up, for an operand is no closed surface.
  void forget() { lines_.clear(); }

  /// Returns the ratio of a result's volume to the operation's, or 1 where the difference may be
  /// chance (three standard errors). Triangles of `result` are about as long as voxels. Throws
  /// Interrupted.
  double ratioOf(const Surface& result, double volume, Executor& executor) const;

private:
  struct Line
  {
    SurfaceSample sample;      ///< any place of it; the normal is its axis
    std::vector<double> sides; ///< where it enters and leaves the solid, in turn
  };

  std::vector<SurfaceSample> samples() const;
  double lengthInside(const std::vector<double>& sides, int axis) const;

  Bounds box_; ///< of the grid's samples
  Eigen::Vector3d voxel_;
  double tests_; ///< of lines by triangles, for each operand
  BooleanOperation operation_;
  bool isFirst_ = true;
  std::vector<Line> lines_; ///< empty where nothing is known
};

} // namespace winding
