// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/InputUnits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace
{

using winding::Bounds;
using winding::NamedBounds;
using Place = Eigen::Vector3d;

NamedBounds input(const std::string& name, const Place& low, const Place& high, double scale = 1)
{
  return {name, Bounds(scale * low, scale * high)};
}

/// Returns what is said of inputs; empty for nothing.
std::string said(const std::vector<NamedBounds>& inputs)
{
  const auto advice = winding::unitAdvice(inputs);
  return advice ? winding::sentenceOf(*advice) : "";
}

/// A part of a machine.
NamedBounds part(const std::string& name, double scale = 1, const Place& at = {3, -2, 50})
{
  return input(name, at, at + Place(100, 70, 20), scale);
}

} // namespace

TEST(InputUnits, OfInputsThatFitAreNotNoticed)
{
  const NamedBounds nothing = {"nothing", Bounds()};
  EXPECT_EQ(said({}), "");
  EXPECT_EQ(said({part("one")}), "");
  EXPECT_EQ(said({part("one"), part("two"), part("three", 1, {0, 0, 0})}), "");
  EXPECT_EQ(said({part("one"), nothing, nothing}), "");
  EXPECT_EQ(said({input("a", {0, 0, 0}, {0, 0, 0}), input("b", {1, 1, 1}, {1, 1, 1})}), "");
}

TEST(InputUnits, OfTheSmallerOfTwoIsNoticed)
{
  for (const auto& [ratio, factor] :
    {std::make_pair(25.4, "25.4"), {304.8, "304.8"}, {1000.0, "1000"}})
  {
    const std::string start =
      "'small' seems to be in another unit: scale it by " + std::string(factor) + ";";
    for (const Place& at : {Place(3, -2, 50), Place(0, 0, 0)})
    {
      const NamedBounds small = part("small", 1 / ratio, at), large = part("large");
      EXPECT_EQ(said({large, small}).rfind(start, 0), 0u) << said({large, small});
      EXPECT_EQ(said({part("one", 1.1), small, large}).rfind(start, 0), 0u);
    }
  }
  EXPECT_EQ(said({part("small", 1 / 25.4), part("large")}),
    "'small' seems to be in another unit: scale it by 25.4; then it is as large as 'large', whose "
    "diagonal is 124");
}

TEST(InputUnits, FarFieldsAreNone)
{
  for (const double ratio : {10.0, 100.0})
  {
    EXPECT_EQ(said({part("body", 1 / ratio), part("far field")}), "") << ratio;
  }
}

TEST(InputUnits, AreComparedWithinAHundredthOfTheLongestSide)
{
  for (const double near : {0.991, 1.009})
  {
    EXPECT_NE(said({part("small", near / 25.4), part("large")}), "") << near;
  }
  for (const double off : {0.989, 1.011})
  {
    EXPECT_EQ(said({part("small", off / 25.4), part("large")}), "") << off;
  }
}

TEST(InputUnits, OfOtherShapesAreNotNoticed)
{
  const NamedBounds ship = input("ship", {-20, -8, -3}, {120, 8, 30});
  EXPECT_EQ(said({ship, input("bolt", {3, 2, 1}, {3.02, 2.02, 1.1})}), "");
  EXPECT_EQ(said({ship, input("turned", {0, 0, 0}, {0.016, 0.14, 0.033})}), "");
  EXPECT_EQ(said({ship, input("flat", {0, 0, 0}, {0.14, 0.016, 0})}), "");
  EXPECT_NE(
    said({input("wall", {0, 0, 0}, {4, 3, 0}), input("in mm", {0, 0, 9}, {4000, 3000, 9})}), "");
}

TEST(InputUnits, OfRandomPartsAreNotNoticed)
{
  // Sizes of parts from 1/1000 of the assembly to all of it, in whole steps as designers have them.
  std::mt19937 random(4);
  std::uniform_real_distribution<double> share(0, 1);
  int alarms = 0;
  constexpr int runs = 20'000;
  for (int run = 0; run < runs; ++run)
  {
    std::vector<NamedBounds> parts;
    for (int part = 0; part < 5; ++part)
    {
      const double size = std::pow(1000, share(random));
      const auto step = [&]()
      {
        return std::round(2 * size * share(random)) / 2;
      };
      const double reach = std::pow(1000, share(random));
      const Place low(std::round(reach * share(random)), std::round(reach * share(random)),
        std::round(reach * share(random)));
      parts.push_back({"part", Bounds(low, low + Place(step(), step(), step()))});
    }
    alarms += static_cast<int>(!said(parts).empty());
  }
  EXPECT_EQ(alarms, 0) << "of " << runs;
}

TEST(InputUnits, DoNotDependOnAUniformScale)
{
  for (const double scale : {1e-60, 1e-3, 1e60})
  {
    EXPECT_NE(said({part("small", scale / 1000), part("large", scale)}), "") << scale;
    EXPECT_EQ(said({part("one", scale), part("two", scale)}), "") << scale;
  }
}
