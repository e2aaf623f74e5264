// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cmath>

namespace winding
{

/**
 * The sign of the area of (from, to, q), in the plane: +1 where q lies to the left of the directed
 * edge, −1 to the right.
 *
 * Guaranteed: (1) exact for all doubles whose products neither overflow nor underflow: a rounded
 * evaluation is used only where its error bound proves the sign, expansions elsewhere (Shewchuk,
 * Adaptive precision floating-point arithmetic and fast robust geometric predicates, 1997);
 * (2) odd under swapping from and to; (3) 0 only if from == to: a q on the line counts as moved by
 * an infinitesimal step along +u and by one infinitely smaller along +v (u, v: first and second
 * coordinate), the same for every edge, so that the edges of a triangulation agree about it.
 */
inline int sideOfEdge(
  const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Eigen::Vector2d& q);

/// The sign that sideOfEdge() gives, without trying first whether rounded arithmetic is enough.
int sideOfEdgeExactly(
  const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Eigen::Vector2d& q);

/**
 * The side of the plane of a triangle that q is on: +1 where the normal (b−a)×(c−a) points away
 * from q, −1 where it points towards q. The side is as exact as sideOfEdge() is. A q in the
 * plane counts as moved by infinitesimal steps: one along y, an infinitely smaller one along z, and
 * one smaller still along x. The steps are sideOfEdge()'s where u, v are y, z. The side is 0
 * only for degenerate triangles.
 */
int sideOfPlane(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
  const Eigen::Vector3d& q);

inline int sideOfEdge(
  const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Eigen::Vector2d& q)
{
  const double left = (to[0] - from[0]) * (q[1] - from[1]);
  const double right = (to[1] - from[1]) * (q[0] - from[0]);
  const double area = left - right;
  // Each difference, product and the last subtraction round once: (3 + 16ε)ε with ε = 2^−53.
  constexpr double errorBound = 3.3306690738754716e-16;
  if (std::abs(area) > errorBound * (std::abs(left) + std::abs(right)))
  {
    return area > 0 ? 1 : -1;
  }
  return sideOfEdgeExactly(from, to, q);
}

} // namespace winding
