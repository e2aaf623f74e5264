// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "diagnosis/ResultWalls.h"

#include <algorithm>
#include <utility>

namespace winding
{

void ResultWalls::add(const Diagnosis& operand, const InsideTest& isInside,
  const std::function<bool(const Eigen::Vector3d& point)>& mayBound, Executor& executor)
{
  this->cutBy(operand, isInside, executor);
  if (isFirst_ || operation_ != BooleanOperation::subtract)
  {
    const WallSamples own = operand.boundingWalls(isInside, executor);
    for (std::size_t i = 0; i < own.points.size(); ++i)
    {
      if (mayBound(own.points[i].position))
      {
        walls_.add(own, i);
      }
    }
  }
  isFirst_ = false;
  constexpr std::size_t most = 1024;
  walls_.leave(most);
}

/// Leaves the walls that an operand leaves, as far as both ends of lines agree.
void ResultWalls::cutBy(const Diagnosis& operand, const InsideTest& isInside, Executor& executor)
{
  const std::vector<SampleLine> lines = operand.linesAlong(walls_, executor);
  WallSamples left;
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    const SampleLine& line = lines[i];
    SampleLine& own = walls_.lines[i];
    const bool isIn = isInside(line.behind);
    const bool isOut = operation_ == BooleanOperation::intersect ? !isIn : isIn;
    if (operation_ != BooleanOperation::exclude && line.isClear() && isOut)
    {
      continue; // the point is not on the surface of the result
    }
    if (operation_ != BooleanOperation::unite)
    {
      const double wall = isIn ? line.wall : line.entry;
      walls_.shares[i] = wall < own.wall ? 1 : walls_.shares[i];
      own.wall = std::min(own.wall, wall);
    }
    left.add(walls_, i);
  }
  if (!lines.empty())
  {
    walls_ = std::move(left);
  }
}

} // namespace winding
