// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/Predicates.h"

#include "support/Samples.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using shapes::Random;
using winding::sideOfEdge;
using Point2 = Eigen::Vector2d;
// Wide integers have room for the exact products of 60-bit coordinates.
using Wide = __int128;

/// A point on an integer lattice; scaled() gives it in doubles.
struct LatticePoint
{
  std::int64_t u, v;
  Point2 scaled(double unit) const
  {
    return {static_cast<double>(u) * unit, static_cast<double>(v) * unit};
  }
};

int exactSign(const LatticePoint& from, const LatticePoint& to, const LatticePoint& q)
{
  const Wide area = static_cast<Wide>(to.u - from.u) * (q.v - from.v) -
                    static_cast<Wide>(to.v - from.v) * (q.u - from.u);
  return (area > 0) - (area < 0);
}

/// The sign for q moved by a small step along u and a much smaller one along v, on a finer lattice.
int exactSignOfMoved(const LatticePoint& from, const LatticePoint& to, const LatticePoint& q)
{
  const auto finer = [](const LatticePoint& p)
  {
    return LatticePoint{p.u * 1000, p.v * 1000};
  };
  const LatticePoint moved{q.u * 1000 + 10, q.v * 1000 + 1};
  return exactSign(finer(from), finer(to), moved);
}

/// All points with coordinates −3 … 3.
std::vector<LatticePoint> smallLattice()
{
  std::vector<LatticePoint> points;
  for (int i = 0; i < 49; ++i)
  {
    points.push_back({i % 7 - 3, i / 7 - 3});
  }
  return points;
}

/// The sign that plain, rounded arithmetic gives.
int roundedSign(const Point2& from, const Point2& to, const Point2& q)
{
  const double area = (to[0] - from[0]) * (q[1] - from[1]) - (to[1] - from[1]) * (q[0] - from[0]);
  return (area > 0) - (area < 0);
}

/// A random integer of 0 … 2^bits − 1.
std::int64_t integer(Random& random, int bits)
{
  return static_cast<std::int64_t>(random.bits() >> (64 - bits));
}

bool isInTriangle(const Point2& a, const Point2& b, const Point2& c, const Point2& q)
{
  const int side = sideOfEdge(a, b, q);
  return side != 0 && sideOfEdge(b, c, q) == side && sideOfEdge(c, a, q) == side;
}

} // namespace

TEST(SideOfEdge, IsPositiveOnTheLeft)
{
  EXPECT_EQ(sideOfEdge({0, 0}, {1, 0}, {0.5, 1}), 1);
  EXPECT_EQ(sideOfEdge({0, 0}, {1, 0}, {0.5, -1}), -1);
}

TEST(SideOfEdge, IsTheSignForASampleMovedAlongUAndFarLessAlongV)
{
  const std::vector<LatticePoint> lattice = smallLattice();
  for (const LatticePoint& from : lattice)
  {
    for (const LatticePoint& to : lattice)
    {
      for (const LatticePoint& q : lattice)
      {
        const int expected = exactSignOfMoved(from, to, q);
        for (const double unit : {1.0, 0x1p-60, 0x1p300})
        {
          ASSERT_EQ(sideOfEdge(from.scaled(unit), to.scaled(unit), q.scaled(unit)), expected)
            << from.u << ' ' << from.v << " -> " << to.u << ' ' << to.v << " : " << q.u << ' '
            << q.v << " times " << unit;
        }
      }
    }
  }
}

TEST(SideOfEdge, IsExactForNearlyCollinearPointsOfManyDigits)
{
  SCOPED_TRACE("seed 51");
  Random random(51);
  std::size_t rounded = 0, onLine = 0;
  for (int i = 0; i < 200000; ++i)
  {
    // (p, p + 1) and (1, 1) span an area of 1, far below the rounding of products of 77 bits.
    const std::int64_t p = 1 + integer(random, 26), step = integer(random, 25) - (1 << 24);
    const std::int64_t beside = integer(random, 2) - 1;
    const LatticePoint from{integer(random, 50), integer(random, 50)};
    const LatticePoint to{from.u + p, from.v + p + 1};
    const LatticePoint q{from.u + step * p + beside, from.v + step * (p + 1) + beside};
    const double unit = std::ldexp(1.0, static_cast<int>(random.bits() % 100));
    const Point2 f = from.scaled(unit), t = to.scaled(unit), r = q.scaled(unit);
    const int expected = exactSign(from, to, q);
    onLine += expected == 0;
    rounded += roundedSign(f, t, r) != expected;
    // A step along +u from the line leads to the right of an edge that rises.
    ASSERT_EQ(sideOfEdge(f, t, r), expected == 0 ? -1 : expected) << i;
  }
  shapes::record("rounded", static_cast<double>(rounded));
  shapes::record("onLine", static_cast<double>(onLine));
  EXPECT_GT(rounded, 10000u) << "too easy to prove anything"; // measured: 149670
  EXPECT_GT(onLine, 10000u);                                  // measured: 50097
}

TEST(SideOfEdge, IsExactWhereTheDifferencesThemselvesRound)
{
  SCOPED_TRACE("seed 52");
  Random random(52);
  std::size_t rounded = 0;
  for (int i = 0; i < 200000; ++i)
  {
    // The edge has 50 bits and starts close to the origin; the point lies beyond it on a coarser
    // lattice, at most a step of that off the line: differences need up to 60 bits, a double has
    // 53.
    const LatticePoint from{integer(random, 8), integer(random, 8)};
    const LatticePoint to{integer(random, 50), integer(random, 50)};
    const double t = random(2, 500);
    const auto along = [&](std::int64_t a, std::int64_t b)
    {
      const double exact = static_cast<double>(a) + t * static_cast<double>(b - a);
      return static_cast<std::int64_t>(std::nextafter(exact, random(0, 1) < 0.5 ? 0 : 0x1p62));
    };
    const LatticePoint q{along(from.u, to.u), along(from.v, to.v)};
    const Point2 f = from.scaled(0x1p-30), e = to.scaled(0x1p-30), r = q.scaled(0x1p-30);
    const int expected = exactSign(from, to, q);
    ASSERT_NE(expected, 0);
    rounded += roundedSign(f, e, r) != expected;
    ASSERT_EQ(sideOfEdge(f, e, r), expected) << i;
  }
  shapes::record("rounded", static_cast<double>(rounded));
  EXPECT_GT(rounded, 1000u) << "too easy to prove anything"; // measured: 59887
}

TEST(SideOfEdge, IsOddAndZeroOnlyForEqualEnds)
{
  SCOPED_TRACE("seed 53");
  Random random(53);
  for (int i = 0; i < 100000; ++i)
  {
    const Point2 from = random.point(-1, 1).head<2>(), to = random.point(-1, 1).head<2>();
    // The point is on the line up to rounding, at an end, or has a coordinate of the end.
    Point2 q = from + random(-0.5, 1.5) * (to - from);
    q = i % 4 == 1 ? from : q;
    q = i % 4 == 2 ? Point2(from[0], q[1]) : q;
    const int side = sideOfEdge(from, to, q);
    ASSERT_NE(side, 0);
    ASSERT_EQ(sideOfEdge(to, from, q), -side);
    ASSERT_EQ(sideOfEdge(from, from, q), 0);
  }
}

TEST(SideOfEdge, PutsEveryPointIntoExactlyOneTriangleOfATriangulation)
{
  SCOPED_TRACE("seed 54");
  Random random(54);
  // The triangulation is a square of n by n cells with random diagonals; its inner vertices are on
  // or off the lattice.
  constexpr int n = 6;
  for (const double jitter : {0.0, 1e-16, 0.2})
  {
    std::vector<Point2> vertices;
    for (int i = 0; i < (n + 1) * (n + 1); ++i)
    {
      const int x = i % (n + 1), y = i / (n + 1);
      const bool inner = x > 0 && x < n && y > 0 && y < n;
      vertices.push_back(Point2(x, y) + (inner ? jitter : 0) * random.point(-1, 1).head<2>());
    }
    std::vector<Point2> samples = vertices;
    for (int i = 0; i < 400; ++i)
    {
      samples.emplace_back(0.5 * (i % 20) - 1, 0.5 * (i / 20) - 1);
      const Point2& a = vertices[random.bits() % vertices.size()];
      const Point2& b = vertices[random.bits() % vertices.size()];
      samples.push_back(a + 0.25 * (b - a));
    }
    std::vector<int> found(samples.size());
    for (int cell = 0; cell < n * n; ++cell)
    {
      const int id = cell / n * (n + 1) + cell % n;
      const Point2 &a = vertices[id], &b = vertices[id + 1];
      const Point2 &c = vertices[id + n + 2], &d = vertices[id + n + 1];
      const bool rising = random.bits() % 2 == 0;
      for (std::size_t i = 0; i < samples.size(); ++i)
      {
        const Point2& q = samples[i];
        found[i] += rising ? isInTriangle(a, b, c, q) + isInTriangle(a, c, d, q)
                           : isInTriangle(b, c, d, q) + isInTriangle(b, d, a, q);
      }
    }
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      // A step towards +u and +v takes the lower sides in and leaves the upper ones out.
      const bool isIn = (samples[i].array() >= 0).all() && (samples[i].array() < n).all();
      ASSERT_EQ(found[i], isIn) << samples[i].transpose() << " jitter " << jitter;
    }
  }
}
