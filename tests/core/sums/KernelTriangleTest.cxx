// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sums/DirectSumKernels.h"
#include "support/Samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{

using shapes::Point;
using shapes::Random;

Point normalOf(const Point& a, const Point& b, const Point& c)
{
  const winding::KernelTriangle triangle = winding::kernelTriangle(a, b, c);
  return {triangle.normal[0], triangle.normal[1], triangle.normal[2]};
}

/// Two corners near each other and one anywhere, so that any of the three may be the far one.
void makeNeedle(Random& random, Point (&corners)[3])
{
  const Point at = random.point(-1, 1);
  const double width = std::pow(10, random(-9, 0));
  corners[0] = at;
  corners[1] = at + width * random.direction();
  corners[2] = random.point(-1, 1);
  std::rotate(corners, corners + random.bits() % 3, corners + 3);
}

} // namespace

TEST(KernelTriangle, OfANeedleHasANormalRightToTheRoundingOfItsShortSide)
{
  SCOPED_TRACE("seed 392");
  using Exact = Eigen::Matrix<long double, 3, 1>;
  Random random(392);
  double largest = 0;
  for (int i = 0; i < 100'000; ++i)
  {
    Point corners[3];
    makeNeedle(random, corners);
    const Exact a = corners[0].cast<long double>(), b = corners[1].cast<long double>(),
                c = corners[2].cast<long double>();
    // Long double has too few digits, too, for the product of two long sides.
    const Exact sides[] = {b - a, c - b, a - c};
    const auto longest = std::max_element(sides, sides + 3,
      [](const Exact& u, const Exact& v) { return u.squaredNorm() < v.squaredNorm(); });
    const auto other = [&](int side) -> const Exact&
    {
      return sides[(longest - sides + side) % 3];
    };
    const Exact exact = other(1).cross(other(2));
    const Exact error = normalOf(corners[0], corners[1], corners[2]).cast<long double>() - exact;
    largest = std::max(
      largest, static_cast<double>(error.norm() / (other(1).norm() * other(2).norm()) * 0x1p52L));
  }
  shapes::record("largest", largest);
  EXPECT_LT(largest, 2); // measured: 1.2
}

TEST(KernelTriangle, IsOddUnderAnExchangeOfTwoCornersToTheBit)
{
  SCOPED_TRACE("seed 393");
  Random random(393);
  for (int i = 0; i < 10'000; ++i)
  {
    Point corners[3];
    makeNeedle(random, corners);
    const auto& [a, b, c] = corners;
    ASSERT_EQ(normalOf(a, c, b), -normalOf(a, b, c));
  }
  // Two sides are equally long, or all three.
  const Point a(1, 0, 0), b(0, 1, 0), c(0, 0, 1), far(0.3, 0.3, 7);
  for (const auto& [p, q, r] :
    {std::array{a, b, c}, std::array{a, b, far}, std::array{far, a, b}, std::array{b, far, a}})
  {
    EXPECT_EQ(normalOf(p, r, q), -normalOf(p, q, r));
  }
}
