// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sums/SolidAngle.h"
#include "base/Pi.h"

#include "support/QuadAngle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using shapes::Point;
using shapes::Random;
using LongPoint = winding::Vector3<long double>;

double angle(const Point& a, const Point& b, const Point& c)
{
  return winding::solidAngle<double>(a, b, c);
}

/// The spherical excess, from the three dihedral angles at the origin.
long double excessFromDihedralAngles(const LongPoint& a, const LongPoint& b, const LongPoint& c)
{
  const auto dihedral = [](const LongPoint& edge, const LongPoint& left, const LongPoint& right)
  {
    const LongPoint n = edge.cross(left), m = edge.cross(right);
    return std::atan2(n.cross(m).norm(), n.dot(m));
  };
  const long double longPi = std::acos(-1.0L);
  const long double excess = dihedral(a, b, c) + dihedral(b, c, a) + dihedral(c, a, b) - longPi;
  return a.dot(b.cross(c)) < 0 ? -excess : excess;
}

/// The spherical excess E from the sides alone, with half their sum as s (L'Huilier):
/// tan²(E/4) = tan(s/2) tan((s−a)/2) tan((s−b)/2) tan((s−c)/2).
long double excessByLHuilier(const LongPoint& a, const LongPoint& b, const LongPoint& c)
{
  const auto side = [](const LongPoint& p, const LongPoint& q)
  {
    return std::atan2(p.cross(q).norm(), p.dot(q));
  };
  const long double ab = side(a, b), bc = side(b, c), ca = side(c, a), s = (ab + bc + ca) / 2;
  const long double product =
    std::tan(s / 2) * std::tan((s - ab) / 2) * std::tan((s - bc) / 2) * std::tan((s - ca) / 2);
  const long double excess = 4 * std::atan(std::sqrt(std::max(product, 0.0L)));
  return a.dot(b.cross(c)) < 0 ? -excess : excess;
}

struct Corners
{
  Point a, b, c;
};

std::vector<Corners> randomTriangles(std::size_t count, unsigned seed)
{
  Random random(seed);
  std::vector<Corners> triangles(count);
  for (Corners& t : triangles)
  {
    t = {random.point(-1, 1), random.point(-1, 1), random.point(-1, 1)};
  }
  return triangles;
}

} // namespace

TEST(SolidAngle, OfAnOctantIsHalfPi)
{
  EXPECT_DOUBLE_EQ(angle({1, 0, 0}, {0, 2, 0}, {0, 0, 3}), winding::pi / 2);
}

TEST(SolidAngle, EqualsTheSphericalExcessByTwoOtherFormulas)
{
  SCOPED_TRACE("seed 1");
  double worstDihedral = 0, worstLHuilier = 0;
  for (const auto& [a, b, c] : randomTriangles(20000, 1))
  {
    const LongPoint la = a.cast<long double>();
    const LongPoint lb = b.cast<long double>();
    const LongPoint lc = c.cast<long double>();
    worstDihedral = std::max(worstDihedral,
      std::abs(static_cast<double>(angle(a, b, c) - excessFromDihedralAngles(la, lb, lc))));
    worstLHuilier = std::max(worstLHuilier,
      std::abs(static_cast<double>(
        winding::solidAngle<long double>(la, lb, lc) - excessByLHuilier(la, lb, lc))));
  }
  shapes::record("worstDihedral", worstDihedral);
  shapes::record("worstLHuilier", worstLHuilier);
  EXPECT_LT(worstDihedral, 1e-12); // measured: 9.7e-14
  EXPECT_LT(worstLHuilier, 1e-13); // measured: 3.7e-15
}

TEST(SolidAngle, KeepsItsDigitsForSmallFarTriangles)
{
  SCOPED_TRACE("seed 2");
  Random random(2);
  double worst = 0;
  for (int i = 0; i < 10000; ++i)
  {
    const Point a = 1e5 * random.direction();
    // The normal is along the line of sight, for the angle of an edge-on triangle is itself a small
    // difference.
    const Point u = a.cross(random.direction()).normalized(), v = a.cross(u).normalized();
    const Point b = a + u, c = a + v;
    const long double exact = winding::solidAngle<long double>(
      a.cast<long double>(), b.cast<long double>(), c.cast<long double>());
    worst = std::max(worst, std::abs(static_cast<double>(angle(a, b, c) / exact - 1)));
  }
  shapes::record("worst", worst);
  EXPECT_LT(worst, 1e-14); // measured: 5.5e-16
}

TEST(SolidAngle, OfANeedleLosesNoMoreThanItsCoordinatesDo)
{
  SCOPED_TRACE("seed 7");
  Random random(7);
  double worst = 0;
  for (int i = 0; i < 100000; ++i)
  {
    const shapes::Needle needle(random);
    const auto& [a, b, c] = needle.corners;
    const double exact =
      shapes::quadSolidAngle(shapes::QuadVector(a), shapes::QuadVector(b), shapes::QuadVector(c));
    const double error = std::remainder(angle(a, b, c) - exact, 4 * winding::pi);
    worst = std::max(worst, std::abs(error) / (1 + needle.ratioAt(Point::Zero())));
  }
  shapes::record("worst", worst);
  EXPECT_LT(worst, 4e-15); // measured: 1.5e-15
}

TEST(SolidAngle, IsOddToTheBitUnderTheExchangeOfTwoCorners)
{
  SCOPED_TRACE("seed 3");
  for (const auto& [a, b, c] : randomTriangles(20000, 3))
  {
    ASSERT_EQ(angle(a, b, c), -angle(a, c, b));
  }
  Random random(8);
  for (int i = 0; i < 20000; ++i)
  {
    const auto& [a, b, c] = shapes::Needle(random).corners;
    ASSERT_EQ(angle(a, b, c), -angle(a, c, b));
  }
}

TEST(SolidAngle, DoesNotDependOnTheFirstCorner)
{
  SCOPED_TRACE("seed 4");
  double worst = 0;
  for (const auto& [a, b, c] : randomTriangles(20000, 4))
  {
    worst = std::max(worst, std::abs(angle(a, b, c) - angle(b, c, a)));
  }
  shapes::record("worst", worst);
  EXPECT_LT(worst, 1e-12); // measured: 1.8e-13
}

TEST(SolidAngle, ComesCloseToTwoPiJustBelowATriangleAndNeverReachesIt)
{
  const Point a(-1, -1, 0), b(1, -1, 0), c(0, 1, 0);
  for (double height = 1; height > 1e-12; height /= 10)
  {
    const Point q(0, -0.25, -height);
    const double below = angle(a - q, b - q, c - q);
    EXPECT_LT(below, 2 * winding::pi);
    // The difference from 2π is proportional to the height: measured, at most 8.54 times it.
    EXPECT_GT(below, 2 * winding::pi - 9 * height);
  }
}

TEST(SolidAngle, IsZeroInThePlaneOfTheTriangle)
{
  const Point a(0, 0, 3), b(4, 1, 3), c(1, 5, 3);
  for (int x = -2; x <= 6; ++x)
  {
    for (int y = -2; y <= 6; ++y)
    {
      const Point q(x, y, 3);
      ASSERT_EQ(angle(a - q, b - q, c - q), 0) << q.transpose();
    }
  }
}

TEST(SolidAngle, IsZeroAtTheVertices)
{
  SCOPED_TRACE("seed 4");
  for (const Corners& t : randomTriangles(1000, 4))
  {
    for (const Point& q : {t.a, t.b, t.c})
    {
      ASSERT_EQ(angle(t.a - q, t.b - q, t.c - q), 0) << q.transpose();
    }
  }
}

TEST(SolidAngle, OfDegenerateTrianglesIsZero)
{
  const Point a(1, 2, 3), b(0.5, -1, 2), middle = 0.5 * (a + b);
  EXPECT_EQ(angle(a, a, a), 0);
  EXPECT_EQ(angle(a, a, b), 0);
  EXPECT_EQ(angle(a, b, a), 0);
  EXPECT_EQ(angle(b, a, a), 0);
  EXPECT_EQ(angle(a, b, middle), 0);
  EXPECT_EQ(angle({0, 0, 0}, a, b), 0) << "the sample is a corner";
}

TEST(SolidAngle, KeepsItsBitsUnderScalingByPowersOfTwo)
{
  SCOPED_TRACE("seed 5");
  for (const auto& [a, b, c] : randomTriangles(2000, 5))
  {
    for (const double scale : {0x1p-100, 0x1p-20, 0x1p20, 0x1p100})
    {
      ASSERT_EQ(angle(scale * a, scale * b, scale * c), angle(a, b, c));
    }
  }
}

TEST(DipoleSolidAngle, IsAreaTimesCosineOverSquaredDistance)
{
  const auto dipole = winding::dipoleSolidAngle<double>;
  EXPECT_DOUBLE_EQ(dipole({0, 0, 2}, {0, 0, 1}, 3), 0.75);
  EXPECT_DOUBLE_EQ(dipole({0, 0, 2}, {0, 0, -1}, 3), -0.75);
  EXPECT_DOUBLE_EQ(dipole({0, 0, 2}, {0, 0.6, 0.8}, 3), 0.6);
  EXPECT_EQ(dipole({0, 0, 2}, {0, 1, 0}, 3), 0);
  EXPECT_EQ(dipole({0, 0, 0}, {0, 1, 0}, 3), 0) << "the sample is the point";
}

TEST(DipoleSolidAngle, IsTheLimitOfASmallTriangle)
{
  SCOPED_TRACE("seed 6");
  for (const auto& [a, b, c] : randomTriangles(100, 6))
  {
    const Point away = a.normalized() * 2;
    double before = 1;
    for (const double size : {1e-1, 1e-2, 1e-3})
    {
      const Point p = away + size * a, q = away + size * b, r = away + size * c;
      const Point cross = (q - p).cross(r - p);
      const double area = cross.norm() / 2;
      const double dipole =
        winding::dipoleSolidAngle<double>((p + q + r) / 3, cross.normalized(), area);
      const double error = std::abs(angle(p, q, r) - dipole);
      // The next term of the expansion is of second order: size² relative to the area.
      EXPECT_LT(error / area, 2 * size * size);
      EXPECT_LT(error / area, before);
      before = error / area;
    }
  }
}
