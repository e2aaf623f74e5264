// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/Samples.h"

#include <algorithm>
#include <cmath>

/**
 * @file
 * Solid angles by numbers of 113 bits, in which van Oosterom and Strackee's formula loses nothing
 * that shows in double, where the compiler has such numbers.
 */
namespace shapes
{

#ifdef __SIZEOF_FLOAT128__
using Quad = __float128;
#else
using Quad = long double;
#endif

struct QuadVector
{
  explicit QuadVector(const Point& p)
    : x(p.x())
    , y(p.y())
    , z(p.z())
  {
  }
  QuadVector(Quad x, Quad y, Quad z)
    : x(x)
    , y(y)
    , z(z)
  {
  }
  QuadVector operator-(const QuadVector& v) const { return {x - v.x, y - v.y, z - v.z}; }
  Quad dot(const QuadVector& v) const { return x * v.x + y * v.y + z * v.z; }
  QuadVector cross(const QuadVector& v) const
  {
    return {y * v.z - z * v.y, z * v.x - x * v.z, x * v.y - y * v.x};
  }
  Quad norm() const
  {
    const Quad square = this->dot(*this);
    Quad root = std::sqrt(static_cast<long double>(square));
    for (int step = 0; step < 2 && root > 0; ++step)
    {
      root = (root + square / root) / 2; // Newton
    }
    return root;
  }

  Quad x, y, z;
};

/// Returns the solid angle of a triangle whose corners are given minus the sample.
inline double quadSolidAngle(const QuadVector& a, const QuadVector& b, const QuadVector& c)
{
  const Quad numerator = a.dot((b - a).cross(c - a));
  const Quad denominator = a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                           b.dot(c) * a.norm() + c.dot(a) * b.norm();
  return static_cast<double>(
    2 * std::atan2(static_cast<long double>(numerator), static_cast<long double>(denominator)));
}

/// A triangle of any thinness, up to 1e8 times as long as it is wide, seen from near it.
struct Needle
{
  explicit Needle(Random& random)
  {
    const double length = std::pow(10, random(0, 8)), width = std::pow(10, random(-3, 1));
    const Point along = random.direction(), across = along.unitOrthogonal();
    corners[0] = random(-1, 0) * length * along + random.point(-1, 1);
    corners[1] = corners[0] + length * along + random(-1, 1) * width * across;
    corners[2] = corners[random.bits() % 2] + width * random.direction();
    if (random(0, 1) < 0.3)
    {
      corners[2] += random(0, 1) * length * along;
    }
    std::rotate(corners, corners + random.bits() % 3, corners + 3);
  }

  /// Returns the longest side divided by the distance of `sample` from the nearest one.
  double ratioAt(const Point& sample) const
  {
    double longest = 0, nearest = HUGE_VAL;
    for (int i = 0; i < 3; ++i)
    {
      const Point from = corners[i] - sample, side = corners[(i + 1) % 3] - corners[i];
      const double at = std::min(1.0, std::max(0.0, -from.dot(side) / side.squaredNorm()));
      longest = std::max(longest, side.norm());
      nearest = std::min(nearest, (from + at * side).norm());
    }
    return longest / nearest;
  }

  Point corners[3];
};

} // namespace shapes
