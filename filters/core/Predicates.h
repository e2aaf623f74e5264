#pragma once

#include <Eigen/Core>

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
int sideOfEdge(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Eigen::Vector2d& q);

/**
 * The sign of the volume of (a, b, c, q), that of (a − q)·((b − a)×(c − a)): +1 where q lies behind
 * the triangle, seen against its normal, −1 in front of it, 0 in its plane. Exact as sideOfEdge.
 */
int sideOfPlane(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
  const Eigen::Vector3d& q);

} // namespace winding
