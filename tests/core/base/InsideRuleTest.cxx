// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/InsideRule.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

using winding::InsideRule;
using winding::InsideTest;

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

} // namespace

TEST(InsideRule, SignedThresholdTakesTheThresholdItselfIn)
{
  const InsideTest isInside;
  EXPECT_TRUE(isInside(0.5));
  EXPECT_FALSE(isInside(std::nextafter(0.5, 0.0)));
  EXPECT_TRUE(isInside(2));
  EXPECT_FALSE(isInside(-1));
  EXPECT_TRUE((InsideTest{InsideRule::signedThreshold, -0.5}(-0.25)));
}

TEST(InsideRule, AbsoluteThresholdTakesInvertedSolidsToo)
{
  const InsideTest isInside = {InsideRule::absoluteThreshold};
  EXPECT_TRUE(isInside(1));
  EXPECT_TRUE(isInside(-1));
  EXPECT_TRUE(isInside(-0.5));
  EXPECT_FALSE(isInside(-0.25));
}

TEST(InsideRule, OddLooksAtTheNearestIntegerAlone)
{
  for (const double threshold : {-10.0, 0.5, 10.0})
  {
    const InsideTest isInside = {InsideRule::odd, threshold};
    EXPECT_FALSE(isInside(0));
    EXPECT_TRUE(isInside(1));
    EXPECT_TRUE(isInside(-1));
    EXPECT_FALSE(isInside(2));
    EXPECT_FALSE(isInside(-2));
    EXPECT_TRUE(isInside(3));
    EXPECT_TRUE(isInside(0.75));
    EXPECT_TRUE(isInside(1.25));
    EXPECT_FALSE(isInside(0.25));
    EXPECT_FALSE(isInside(-1.75));
  }
}

TEST(InsideRule, NothingIsInsideWhereTheValueIsNoNumber)
{
  for (const auto rule :
    {InsideRule::signedThreshold, InsideRule::absoluteThreshold, InsideRule::odd})
  {
    EXPECT_FALSE(InsideTest{rule}(notANumber));
  }
}

TEST(InsideTest, HasAHighThresholdAboveAHalf)
{
  EXPECT_FALSE(InsideTest().hasHighThreshold());
  EXPECT_TRUE((InsideTest{InsideRule::absoluteThreshold, 0.6}.hasHighThreshold()));
  EXPECT_FALSE((InsideTest{InsideRule::odd, 0.6}.hasHighThreshold()));
}
