#pragma once

#include "Predicates.h"

#include <Eigen/Core>

namespace winding
{

/**
 * A triangle prepared for many rays along +x. Whether a ray meets it is decided exactly, as far as
 * Predicates.h goes, also for rays through edges, through vertices and along faces: the point that a
 * ray starts from counts as moved by the infinitesimal steps of sideOfPlane().
 */
class RayTarget
{
public:
  RayTarget(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
    : corners_{a, b, c}
    , across_{a.tail<2>(), b.tail<2>(), c.tail<2>()}
    , low_(a.cwiseMin(b).cwiseMin(c))
    , high_(a.cwiseMax(b).cwiseMax(c))
  {
  }

  /// +1 where the ray from (x, y, z) leaves the solid that the triangle bounds, −1 where it enters it, 0
  /// where it does not meet the triangle. The sum over a closed surface is its winding number there.
  int crossingFrom(double x, double y, double z) const
  {
    if (x > high_[0] || y < low_[1] || y > high_[1] || z < low_[2] || z > high_[2])
    {
      return 0;
    }
    const Eigen::Vector2d q(y, z);
    const int side = sideOfEdge(across_[0], across_[1], q);
    if (side == 0 || sideOfEdge(across_[1], across_[2], q) != side ||
        sideOfEdge(across_[2], across_[0], q) != side)
    {
      return 0;
    }
    if (x < low_[0])
    {
      return side;
    }
    // The sample is within the triangle's extent along the ray: which side of its plane is it on?
    return sideOfPlane(corners_[0], corners_[1], corners_[2], {x, y, z}) * side > 0 ? side : 0;
  }

private:
  Eigen::Vector3d corners_[3];
  Eigen::Vector2d across_[3]; ///< their coordinates y, z across the rays
  Eigen::Vector3d low_, high_;
};

} // namespace winding
