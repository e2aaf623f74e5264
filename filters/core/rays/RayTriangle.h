// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rays/Predicates.h"

#include <Eigen/Core>

namespace winding
{

/// A triangle prepared for many rays along +x. Every decision is as exact as Predicates.h allows.
class RayTriangle
{
public:
  RayTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
    : corners_{a, b, c}
    , low_(a.cwiseMin(b).cwiseMin(c))
    , high_(a.cwiseMax(b).cwiseMax(c))
  {
  }

  /// The crossing of the ray from q: +1 if it leaves through the front of the triangle, −1 if it
  /// enters, 0 if it does not cross. A ray through an edge or a vertex, and a start on the
  /// triangle, count as moved by infinitesimal steps, the same ones for all triangles.
  int crossing(const Eigen::Vector3d& q) const
  {
    // The conditions share one branch, for it cannot be foretold which of them holds.
    const bool isBeside = (q[1] < low_[1]) | (q[1] >= high_[1]) | (q[2] < low_[2]) |
                          (q[2] >= high_[2]) | (q[0] > high_[0]);
    if (isBeside)
    {
      return 0;
    }
    const Eigen::Vector2d across = q.tail<2>();
    const auto sideOf = [&](int from, int to)
    {
      return sideOfEdge(corners_[from].tail<2>(), corners_[to].tail<2>(), across);
    };
    const int side = sideOf(0, 1);
    if (side == 0 || sideOf(1, 2) != side || sideOf(2, 0) != side)
    {
      return 0;
    }
    // The side of the plane decides for a start within the triangle's extent along the ray.
    const bool isAhead =
      q[0] < low_[0] || sideOfPlane(corners_[0], corners_[1], corners_[2], q) == side;
    return isAhead ? side : 0;
  }

private:
  Eigen::Vector3d corners_[3];
  Eigen::Vector3d low_, high_;
};

} // namespace winding
