// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/BooleanOperation.h"
#include "diagnosis/Diagnosis.h"

#include <functional>

namespace winding
{

/**
 * The walls of the result of an operation on solids, by points of the operands' surfaces. Of a
 * difference these are points of the first solid.
 *
 * Each operand is looked at once, when it is added: lines through the points that are kept find
 * what it leaves of their walls. So no operand is needed later. Points of clouds are none, and
 * clouds take no wall away. 1024 points are kept at most.
 */
class ResultWalls
{
public:
  explicit ResultWalls(BooleanOperation operation)
    : operation_(operation)
  {
  }

  /// Adds the next operand. `mayBound` says of a point of it whether the operands before leave it
  /// on the surface of the result. Throws Interrupted.
  void add(const Diagnosis& operand, const InsideTest& isInside,
    const std::function<bool(const Eigen::Vector3d& point)>& mayBound, Executor& executor);

  const WallSamples& walls() const { return walls_; }

private:
  void cutBy(const Diagnosis& operand, const InsideTest& isInside, Executor& executor);

  BooleanOperation operation_;
  bool isFirst_ = true;
  WallSamples walls_;
};

} // namespace winding
