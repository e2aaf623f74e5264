// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/SinglePrecision.h"

#include "vtkPointSet.h"

#include <algorithm>
#include <cmath>
#include <limits>

SinglePrecision singlePrecisionOf(vtkPointSet* points)
{
  if (points->GetNumberOfPoints() == 0)
  {
    return SinglePrecision::holds;
  }
  double bounds[6];
  points->GetPoints()->GetBounds(bounds);
  double largest = 0, longest = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    largest = std::max({largest, std::abs(bounds[2 * axis]), std::abs(bounds[2 * axis + 1])});
    longest = std::max(longest, bounds[2 * axis + 1] - bounds[2 * axis]);
  }
  using Single = std::numeric_limits<float>;
  constexpr double acceptable = 1e-4, fatal = 0.1; // shares of the longest side
  if (largest > Single::max() || (longest > 0 && acceptable * longest < Single::min()))
  {
    return SinglePrecision::isExceeded;
  }
  const double step = largest * Single::epsilon();
  if (longest == 0 || step <= acceptable * longest)
  {
    return SinglePrecision::holds;
  }
  return step <= fatal * longest ? SinglePrecision::movesPoints : SinglePrecision::collapsesPoints;
}
