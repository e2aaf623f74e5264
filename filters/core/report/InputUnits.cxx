// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/InputUnits.h"

#include "base/Digits.h"

namespace winding
{

namespace
{

constexpr std::size_t mostInputs = 1000; // whose pairs are compared within 40 ms
constexpr double tolerance = 0.01;       // of the longest side
/// Millimetres in an inch, a foot and a metre. A box 10 or 100 times as large as another one is
/// more often a far field than in another unit.
constexpr double ratios[] = {25.4, 304.8, 1000};

/// Returns whether a box is as large as another one times a ratio, along all axes.
bool isLarger(double ratio, const Bounds& large, const Bounds& small)
{
  const Eigen::Vector3d sides = large.sizes();
  return !large.isEmpty() && !small.isEmpty() && sides.maxCoeff() > 0 &&
         (ratio * small.sizes() - sides).cwiseAbs().maxCoeff() <= tolerance * sides.maxCoeff();
}

} // namespace

std::optional<Message> unitAdvice(const std::vector<NamedBounds>& inputs)
{
  const std::size_t compared = inputs.size() > mostInputs ? 0 : inputs.size();
  for (std::size_t pair = 0; pair < compared * compared; ++pair)
  {
    const NamedBounds &small = inputs[pair / compared], &large = inputs[pair % compared];
    for (const double ratio : ratios)
    {
      if (isLarger(ratio, large.bounds, small.bounds))
      {
        return Message("'" + small.name + "' seems to be in another unit",
          {{"scale it by " + inDigits(ratio), {}}},
          "then it is as large as '" + large.name + "', whose diagonal is " +
            inDigits(large.bounds.diagonal().norm(), 3));
      }
    }
  }
  return std::nullopt;
}

} // namespace winding
