// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/Predicates.h"

#include "support/Samples.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using shapes::Point;
using shapes::Random;
using winding::sideOfEdge;
using winding::sideOfPlane;
using Wide = __int128;
using Lattice = Eigen::Matrix<std::int64_t, 3, 1>;

/// Sign of (a − q) · ((b − a) × (c − a)), whose value must fit 127 bits.
int exactSign(const Lattice& a, const Lattice& b, const Lattice& c, const Lattice& q)
{
  const Eigen::Matrix<Wide, 3, 1> u = (b - a).cast<Wide>(), v = (c - a).cast<Wide>();
  const Eigen::Matrix<Wide, 3, 1> offset = (a - q).cast<Wide>();
  Wide sum = 0;
  for (int x = 0; x < 3; ++x)
  {
    const int y = (x + 1) % 3, z = (x + 2) % 3;
    sum += offset[x] * (u[y] * v[z] - u[z] * v[y]);
  }
  return (sum > 0) - (sum < 0);
}

/// The sign that plain, rounded arithmetic gives.
int roundedSign(const Point& a, const Point& b, const Point& c, const Point& q)
{
  const double sum = (a - q).dot((b - a).cross(c - a));
  return (sum > 0) - (sum < 0);
}

Point scaled(const Lattice& p, double unit)
{
  return p.cast<double>() * unit;
}

/// Point n of {−1, 0, 1}³.
Lattice smallLattice(int n)
{
  return {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
}

/// A random integer of 0 … 2^bits − 1.
std::int64_t integer(Random& random, int bits)
{
  return static_cast<std::int64_t>(random.bits() >> (64 - bits));
}

Lattice lattice(Random& random, int bits)
{
  const std::int64_t x = integer(random, bits), y = integer(random, bits);
  return {x, y, integer(random, bits)};
}

} // namespace

TEST(SideOfPlane, IsPositiveBehindTheTriangle)
{
  EXPECT_EQ(sideOfPlane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, -1}), 1);
  EXPECT_EQ(sideOfPlane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 1}), -1);
}

TEST(SideOfPlane, IsTheSignForASampleMovedAlongYAndFarLessAlongZAndFarLessStillAlongX)
{
  for (int n = 0; n < 27 * 27 * 27 * 27; ++n)
  {
    const Lattice a = smallLattice(n % 27), b = smallLattice(n / 27 % 27);
    const Lattice c = smallLattice(n / (27 * 27) % 27), q = smallLattice(n / (27 * 27 * 27));
    constexpr std::int64_t finer = 100'000'000;
    const Lattice moved = finer * q + Lattice(1, 10000, 100);
    const int expected = exactSign(finer * a, finer * b, finer * c, moved);
    const bool degenerate = (b - a).cross(c - a).isZero();
    ASSERT_EQ(expected == 0, degenerate);
    const double unit = n % 3 == 0 ? 1 : n % 3 == 1 ? 0x1p-60 : 0x1p200;
    ASSERT_EQ(
      sideOfPlane(scaled(a, unit), scaled(b, unit), scaled(c, unit), scaled(q, unit)), expected)
      << a.transpose() << ", " << b.transpose() << ", " << c.transpose() << " : " << q.transpose();
  }
}

TEST(SideOfPlane, IsExactForNearlyCoplanarPointsOfManyDigits)
{
  SCOPED_TRACE("seed 111");
  Random random(111);
  std::size_t rounded = 0, inPlane = 0;
  for (int i = 0; i < 200000; ++i)
  {
    // Products have up to 117 bits; the sample is at most a lattice step off the plane.
    const Lattice a = lattice(random, 36), b = lattice(random, 36), c = lattice(random, 36);
    const Lattice beside(integer(random, 1), 0, i % 2 == 0 ? 0 : integer(random, 1));
    const Lattice q =
      a + (integer(random, 2) - 1) * (b - a) + (integer(random, 2) - 1) * (c - a) + beside;
    const double unit = std::ldexp(1.0, static_cast<int>(random.bits() % 100) - 50);
    const Point p[4] = {scaled(a, unit), scaled(b, unit), scaled(c, unit), scaled(q, unit)};
    const int expected = exactSign(a, b, c, q);
    inPlane += expected == 0;
    rounded += roundedSign(p[0], p[1], p[2], p[3]) != expected;
    const int side = sideOfPlane(p[0], p[1], p[2], p[3]);
    ASSERT_NE(side, 0);
    if (expected != 0)
    {
      ASSERT_EQ(side, expected) << i;
    }
  }
  shapes::record("rounded", static_cast<double>(rounded));
  shapes::record("inPlane", static_cast<double>(inPlane));
  EXPECT_GT(rounded, 10000u) << "too easy to prove anything"; // measured: 46677
  EXPECT_GT(inPlane, 10000u);                                 // measured: 74833
}

TEST(SideOfPlane, IsExactWhereTheDifferencesThemselvesRound)
{
  SCOPED_TRACE("seed 112");
  Random random(112);
  std::size_t rounded = 0;
  for (int i = 0; i < 200000; ++i)
  {
    // The corners' x have 60 bits as seen from a corner with the lowest bits, y and z have 20; the
    // sample's x is that of the plane, rounded to a double.
    const auto corner = [&](int bits, int shift) -> Lattice
    {
      const std::int64_t x = integer(random, bits) << shift, y = integer(random, 20);
      return {x, y, integer(random, 20)};
    };
    const Lattice a = corner(8, 0), b = corner(50, 10), c = corner(50, 10);
    Lattice q = corner(8, 0);
    const Lattice u = b - a, v = c - a, d = q - a;
    const Wide nx = static_cast<Wide>(u[1]) * v[2] - static_cast<Wide>(u[2]) * v[1];
    const Wide ny = static_cast<Wide>(u[2]) * v[0] - static_cast<Wide>(u[0]) * v[2];
    const Wide nz = static_cast<Wide>(u[0]) * v[1] - static_cast<Wide>(u[1]) * v[0];
    if (nx == 0)
    {
      continue;
    }
    const Wide x = a[0] - (ny * d[1] + nz * d[2]) / nx;
    if (x > (Wide{1} << 61) || x < -(Wide{1} << 61))
    {
      continue;
    }
    q[0] = static_cast<std::int64_t>(static_cast<double>(x));
    const Point p[4] = {scaled(a, 1), scaled(b, 1), scaled(c, 1), scaled(q, 1)};
    const int expected = exactSign(a, b, c, q);
    rounded += roundedSign(p[0], p[1], p[2], p[3]) != expected;
    if (expected != 0)
    {
      ASSERT_EQ(sideOfPlane(p[0], p[1], p[2], p[3]), expected) << i;
    }
  }
  shapes::record("rounded", static_cast<double>(rounded));
  EXPECT_GT(rounded, 1000u) << "too easy to prove anything"; // measured: 89399
}

TEST(SideOfPlane, IsOddUnderSwapsAndZeroOnlyForDegenerateTriangles)
{
  SCOPED_TRACE("seed 113");
  Random random(113);
  for (int i = 0; i < 100000; ++i)
  {
    const Point a = random.point(-1, 1), b = random.point(-1, 1);
    const Point c = i % 4 == 1 ? Point(a[0], a[1], b[2]) : random.point(-1, 1);
    // The sample is in the plane up to rounding, or a corner.
    const Point q = i % 3 == 0 ? a : Point(a + random(-1, 1) * (b - a) + random(-1, 1) * (c - a));
    const int side = sideOfPlane(a, b, c, q);
    ASSERT_NE(side, 0);
    ASSERT_EQ(sideOfPlane(b, a, c, q), -side);
    ASSERT_EQ(sideOfPlane(a, c, b, q), -side);
    ASSERT_EQ(sideOfPlane(c, b, a, q), -side);
    ASSERT_EQ(sideOfPlane(b, c, a, q), side);
    ASSERT_EQ(sideOfPlane(a, a, b, q), 0);
    ASSERT_EQ(sideOfPlane(a, b, b, q), 0);
  }
}

TEST(SideOfPlane, OfARowThatCrossesTurnsOnceFromTheSideThatItsEdgesSay)
{
  // The sample of a row along x that crosses by sideOfEdge(), perhaps through an edge or a vertex,
  // is on that side before the plane, on the other side behind it, and on either side in it. This
  // takes one perturbation for both predicates.
  std::size_t crossings = 0;
  for (int n = 0; n < 27 * 27 * 27; ++n)
  {
    const Lattice a = smallLattice(n % 27), b = smallLattice(n / 27 % 27);
    const Lattice c = smallLattice(n / 729);
    const Point p[3] = {scaled(a, 1), scaled(b, 1), scaled(c, 1)};
    for (int row = 0; row < 25; ++row)
    {
      const Eigen::Vector2d yz(0.5 * (row % 5) - 1, 0.5 * (row / 5) - 1);
      const int side = sideOfEdge(p[0].tail<2>(), p[1].tail<2>(), yz);
      if (side == 0 || sideOfEdge(p[1].tail<2>(), p[2].tail<2>(), yz) != side ||
          sideOfEdge(p[2].tail<2>(), p[0].tail<2>(), yz) != side)
      {
        continue;
      }
      ++crossings;
      int turns = 0, last = side;
      for (int i = -5; i <= 5; ++i)
      {
        const int here = sideOfPlane(p[0], p[1], p[2], {0.25 * i, yz[0], yz[1]});
        turns += here != last;
        last = here;
      }
      ASSERT_EQ(sideOfPlane(p[0], p[1], p[2], {-2, yz[0], yz[1]}), side);
      ASSERT_EQ(last, -side);
      ASSERT_EQ(turns, 1);
    }
  }
  shapes::record("crossings", static_cast<double>(crossings));
  EXPECT_GT(crossings, 10000u); // measured: 45360
}
