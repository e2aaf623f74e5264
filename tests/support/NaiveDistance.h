// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/Shapes.h"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>

namespace shapes
{

/// The distance from a triangle in long double: the least of the distances from its edges and, if
/// the point's projection is inside of all three, from its plane. The code shares nothing with the
/// library.
inline double naiveDistance(const Point& p, const Point& a, const Point& b, const Point& c)
{
  using Real = long double;
  using Vector = Eigen::Matrix<Real, 3, 1>;
  const Vector corners[3] = {a.cast<Real>(), b.cast<Real>(), c.cast<Real>()};
  const Vector q = p.cast<Real>();
  const Vector normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  Real nearest = std::numeric_limits<Real>::infinity();
  bool isInside = normal.norm() > 0;
  for (int i = 0; i < 3; ++i)
  {
    const Vector &from = corners[i], &to = corners[(i + 1) % 3];
    const Vector along = to - from, beside = q - from;
    const Real square = along.dot(along), place = along.dot(beside);
    isInside = isInside && normal.dot(along.cross(beside)) >= 0;
    if (place <= 0)
    {
      nearest = std::min(nearest, beside.norm());
    }
    else if (place >= square)
    {
      nearest = std::min(nearest, (q - to).norm());
    }
    else
    {
      nearest = std::min(nearest, (beside - place / square * along).norm());
    }
  }
  if (isInside)
  {
    nearest = std::min(nearest, std::abs(normal.dot(q - corners[0])) / normal.norm());
  }
  return static_cast<double>(nearest);
}

/// The distance from the nearest triangle of a mesh.
inline double naiveDistance(const Point& p, const Mesh& mesh)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& t : mesh.triangles)
  {
    nearest = std::min(nearest,
      naiveDistance(p, mesh.points[static_cast<std::size_t>(t[0])],
        mesh.points[static_cast<std::size_t>(t[1])], mesh.points[static_cast<std::size_t>(t[2])]));
  }
  return nearest;
}

/// The distance from the nearest point of a cloud.
inline double naiveDistance(const Point& p, const std::vector<Point>& points)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const Point& point : points)
  {
    nearest = std::min(nearest, (p - point).stableNorm());
  }
  return nearest;
}

} // namespace shapes
