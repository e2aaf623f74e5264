// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace winding
{

/// Compares by x, then by y, then by z: less than 0 if p comes first, more than 0 if q does.
inline int compareCoordinates(const Eigen::Vector3d& p, const Eigen::Vector3d& q)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (p[axis] != q[axis])
    {
      return p[axis] < q[axis] ? -1 : 1;
    }
  }
  return 0;
}

} // namespace winding
