// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/TargetCells.h"

#include "farfield/Expansions.h"

#include <algorithm>
#include <cmath>

namespace winding
{

TargetSphere TargetCells::sphereOf(const TargetCell& cell) const
{
  return {cell.center, this->level(cell.level).radius};
}

void TargetCells::storePolynomial(
  const TargetCell& cell, int order, const float* coefficients) const
{
  TargetBlock block;
  alignas(64) float values[SampleBlock::capacity];
  for (std::size_t first = 0; first < cell.samples; first += block.samples.count)
  {
    this->fill(cell, first, block);
    evaluatePolynomial(order, coefficients, block.u, block.v, block.w, block.samples.count, values);
    this->store(cell, first, block.samples.count, values, nullptr);
  }
}

LocalShifts::LocalShifts(int order, double ratio, const Eigen::Vector3d& offsets)
  : sideRatio(ratio)
  , quarter(offsets)
{
  const std::size_t rows = paddedCoefficients(order);
  const auto count = static_cast<std::size_t>(coefficientCount(order));
  for (int octant = 0; octant < 8; ++octant)
  {
    const Eigen::Vector3d sign(octant & 1 ? 1 : -1, octant & 2 ? 1 : -1, octant & 4 ? 1 : -1);
    matrices[octant].assign(rows * count, 0);
    for (std::size_t column = 0; column < count; ++column)
    {
      Expansion unit(count);
      unit[column] = 1;
      const Expansion shifted = shiftLocal(order, unit, sign.cwiseProduct(quarter));
      for (int n = 0; n <= order; ++n)
      {
        for (int place = n * n; place < (n + 1) * (n + 1); ++place)
        {
          matrices[octant][column * rows + static_cast<std::size_t>(place)] =
            static_cast<float>(std::pow(ratio, n) * shifted[static_cast<std::size_t>(place)]);
        }
      }
    }
  }
}

void TargetCells::setShifts(int order, int number, const Eigen::Vector3d& quarter)
{
  TargetLevel& level = levels_[static_cast<std::size_t>(number)];
  const TargetLevel& parent = levels_[static_cast<std::size_t>(number) + 1];
  const double ratio = level.side / parent.side;
  const Eigen::Vector3d offsets = quarter / parent.side;
  // Levels of one shape share their matrices.
  const LocalShifts* above = parent.fromParent.get();
  level.fromParent = above && above->sideRatio == ratio && above->quarter == offsets
                       ? parent.fromParent
                       : std::make_shared<const LocalShifts>(order, ratio, offsets);
}

} // namespace winding
