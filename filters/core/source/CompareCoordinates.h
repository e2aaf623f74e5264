#pragma once

#include <Eigen/Core>

#include <cmath>

namespace winding
{

/**
 * Compares two places by |x|, then |y|, then |z|, and where these are equal by x, y and z: less than
 * 0 if p comes first, more than 0 if q does. Sizes come before signs so that a mirrored source is
 * summed in the same order, but for places that mirror each other.
 */
inline int compareCoordinates(const Eigen::Vector3d& p, const Eigen::Vector3d& q)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double a = std::abs(p[axis]), b = std::abs(q[axis]);
    if (a != b)
    {
      return a < b ? -1 : 1;
    }
  }
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
