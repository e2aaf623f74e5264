// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/InsideRule.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

using winding::InsideRule;
using winding::isInside;

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

} // namespace

TEST(InsideRule, SignedThresholdTakesTheThresholdItselfIn)
{
  const auto rule = InsideRule::signedThreshold;
  EXPECT_TRUE(isInside(0.5, rule, 0.5));
  EXPECT_FALSE(isInside(std::nextafter(0.5, 0.0), rule, 0.5));
  EXPECT_TRUE(isInside(2, rule, 0.5));
  EXPECT_FALSE(isInside(-1, rule, 0.5));
  EXPECT_TRUE(isInside(-0.25, rule, -0.5));
}

TEST(InsideRule, AbsoluteThresholdTakesInvertedSolidsToo)
{
  const auto rule = InsideRule::absoluteThreshold;
  EXPECT_TRUE(isInside(1, rule, 0.5));
  EXPECT_TRUE(isInside(-1, rule, 0.5));
  EXPECT_TRUE(isInside(-0.5, rule, 0.5));
  EXPECT_FALSE(isInside(-0.25, rule, 0.5));
}

TEST(InsideRule, OddLooksAtTheNearestIntegerAlone)
{
  const auto rule = InsideRule::odd;
  for (const double threshold : {-10.0, 0.5, 10.0})
  {
    EXPECT_FALSE(isInside(0, rule, threshold));
    EXPECT_TRUE(isInside(1, rule, threshold));
    EXPECT_TRUE(isInside(-1, rule, threshold));
    EXPECT_FALSE(isInside(2, rule, threshold));
    EXPECT_FALSE(isInside(-2, rule, threshold));
    EXPECT_TRUE(isInside(3, rule, threshold));
    EXPECT_TRUE(isInside(0.75, rule, threshold));
    EXPECT_TRUE(isInside(1.25, rule, threshold));
    EXPECT_FALSE(isInside(0.25, rule, threshold));
    EXPECT_FALSE(isInside(-1.75, rule, threshold));
  }
}

TEST(InsideRule, NothingIsInsideWhereTheValueIsNoNumber)
{
  for (const auto rule :
    {InsideRule::signedThreshold, InsideRule::absoluteThreshold, InsideRule::odd})
  {
    EXPECT_FALSE(isInside(notANumber, rule, 0.5));
  }
}
