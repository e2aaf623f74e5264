// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/RowTriangle.h"

#include "rays/Predicates.h"
#include "support/Samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using shapes::Point;
using shapes::Random;
using winding::RowTriangle;

struct Corners
{
  Point a, b, c;
  RowTriangle triangle() const { return {a, b, c}; }
  double low(int axis) const { return std::min({a[axis], b[axis], c[axis]}); }
  double high(int axis) const { return std::max({a[axis], b[axis], c[axis]}); }
};

/// A triangle with lattice corners, one with corners near them, a large one, a sliver, or one in
/// general position, by `kind`. All but the large ones are in [−2, 14]³.
Corners someCorners(Random& random, int kind)
{
  const auto corner = [&]() -> Point
  {
    Point p = random.point(0, 12);
    Point rounded = p.array().round();
    switch (kind % 5)
    {
    case 0:
      return rounded;
    case 1:
      return rounded + 1e-15 * random.point(-1, 1);
    case 2:
      return 1e6 * (p - Point::Constant(6));
    default:
      return p;
    }
  };
  Corners corners{corner(), corner(), corner()};
  if (kind % 5 == 3)
  {
    // The sliver lies along x up to rounding.
    corners.c = corners.a + random(0, 1) * (corners.b - corners.a) + random(-1, 1) * Point::UnitX();
  }
  return corners;
}

} // namespace

TEST(RowTriangle, FindsEveryRowThatCrossesInItsRange)
{
  SCOPED_TRACE("seed 121");
  Random random(121);
  std::size_t crossings = 0, asked = 0;
  for (int n = 0; n < 20000; ++n)
  {
    const RowTriangle triangle = someCorners(random, n).triangle();
    for (int k = 0; k <= 12; k += 3)
    {
      const RowTriangle::Range range = triangle.rowsIn(k, -1, 13);
      ASSERT_TRUE(range.last < range.first || (range.first >= -1 && range.last <= 13));
      asked += static_cast<std::size_t>(std::max(0, range.last - range.first + 1));
      for (int j = -1; j <= 13; ++j)
      {
        if (triangle.crossingSign(j, k) != 0)
        {
          ++crossings;
          ASSERT_TRUE(range.first <= j && j <= range.last) << n << ": " << j << ' ' << k;
        }
      }
    }
  }
  shapes::record("crossings", static_cast<double>(crossings));
  shapes::record("asked", static_cast<double>(asked));
  // A row or two at the ends of a range do not cross, nor do rows along edges. Measured: 1.08
  // times.
  EXPECT_LT(static_cast<double>(asked), 1.3 * static_cast<double>(crossings));
}

TEST(RowTriangle, CutsItsRangeToTheRowsAskedFor)
{
  const RowTriangle triangle({0, -1e6, -1e6}, {0, 1e6, -1e6}, {0, 0, 1e6});
  const RowTriangle::Range all = triangle.rowsIn(0, -10, 10);
  EXPECT_EQ(all.first, -10);
  EXPECT_EQ(all.last, 10);
  const RowTriangle::Range some = triangle.rowsIn(0, 3, 5);
  EXPECT_EQ(some.first, 3);
  EXPECT_EQ(some.last, 5);
  const RowTriangle::Range none = triangle.rowsIn(0, 2'000'000, 2'000'010);
  EXPECT_LT(none.last, none.first);
  const RowTriangle::Range above = triangle.rowsIn(1'000'001, -10, 10);
  EXPECT_LT(above.last, above.first);
}

TEST(RowTriangle, PutsTheFirstSampleBehindWhereThePlaneTurnsItsSide)
{
  SCOPED_TRACE("seed 122");
  Random random(122);
  std::size_t crossings = 0;
  for (int n = 0; n < 20000; ++n)
  {
    const Corners corners = someCorners(random, n);
    const RowTriangle triangle = corners.triangle();
    const int k = static_cast<int>(random.bits() % 13);
    for (int j = -1; j <= 13; ++j)
    {
      const int sign = triangle.crossingSign(j, k);
      if (sign == 0)
      {
        continue;
      }
      ++crossings;
      int expected = -3;
      while (expected <= 15 &&
             winding::sideOfPlane(corners.a, corners.b, corners.c, Point(expected, j, k)) == sign)
      {
        ++expected;
      }
      ASSERT_EQ(triangle.firstBehind(j, k, sign, -3, 15), expected) << n;
      // Shorter ranges give the same sample, cut to the range.
      ASSERT_EQ(triangle.firstBehind(j, k, sign, 2, 6), std::clamp(expected, 2, 7)) << n;
      ASSERT_EQ(triangle.firstBehind(j, k, sign, 5, 5), std::clamp(expected, 5, 6)) << n;
    }
  }
  shapes::record("crossings", static_cast<double>(crossings));
  EXPECT_GT(crossings, 10000u); // measured: 25636
}

TEST(RowTriangle, IsCrossedByAsManyRowsEachWayAsItsReverse)
{
  SCOPED_TRACE("seed 123");
  Random random(123);
  for (int n = 0; n < 5000; ++n)
  {
    const Corners t = someCorners(random, n);
    const RowTriangle triangle(t.a, t.b, t.c), turned(t.b, t.c, t.a), reversed(t.a, t.c, t.b);
    for (int row = 0; row < 169; row += 7)
    {
      const int j = row % 13, k = row / 13, sign = triangle.crossingSign(j, k);
      ASSERT_EQ(turned.crossingSign(j, k), sign);
      ASSERT_EQ(reversed.crossingSign(j, k), -sign);
      if (sign != 0)
      {
        const int behind = triangle.firstBehind(j, k, sign, 0, 12);
        ASSERT_EQ(turned.firstBehind(j, k, sign, 0, 12), behind);
        ASSERT_EQ(reversed.firstBehind(j, k, -sign, 0, 12), behind);
      }
    }
  }
}

TEST(RowTriangle, IsNotCrossedAlongRowsOrWhereItIsALine)
{
  const RowTriangle alongRows({0, 2, 0}, {9, 2, 0}, {4, 2, 5});
  const RowTriangle line({0, 0, 0}, {2, 2, 2}, {4, 4, 4});
  const RowTriangle slantedLine({0, 0, 0}, {5, 2, 2}, {4, 4, 4}); // a line as rows see it
  for (int row = 0; row < 36; ++row)
  {
    EXPECT_EQ(alongRows.crossingSign(row % 6, row / 6), 0);
    EXPECT_EQ(line.crossingSign(row % 6, row / 6), 0);
    EXPECT_EQ(slantedLine.crossingSign(row % 6, row / 6), 0);
  }
}

TEST(RowTriangle, LeavesThroughTheFront)
{
  // The normal of the front is along +x, so a walk along +x leaves.
  const RowTriangle front({4.5, -9, -9}, {4.5, 9, -9}, {4.5, 0, 9});
  EXPECT_EQ(front.crossingSign(0, 0), 1);
  EXPECT_EQ(front.firstBehind(0, 0, 1, 0, 9), 5);
  const RowTriangle back({4.5, -9, -9}, {4.5, 0, 9}, {4.5, 9, -9});
  EXPECT_EQ(back.crossingSign(0, 0), -1);
}
