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

bool begins(const std::string& text, const std::string& start)
{
  return text.rfind(start, 0) == 0;
}

/// A pipe along x from the origin, the disc at its one end and at its other one.
NamedBounds walls(double scale = 1)
{
  return input("walls", {0, -50, -50}, {1000, 50, 50}, scale);
}
NamedBounds inlet(double scale = 1)
{
  return input("inlet", {0, -50, -50}, {0, 50, 50}, scale);
}
NamedBounds outlet(double scale = 1)
{
  return input("outlet", {1000, -50, -50}, {1000, 50, 50}, scale);
}

} // namespace

TEST(InputUnits, OfInputsThatFitAreNotNoticed)
{
  EXPECT_EQ(said({}), "");
  EXPECT_EQ(said({walls()}), "");
  EXPECT_EQ(said({walls(), inlet(), outlet()}), "");
  EXPECT_EQ(said({walls(), inlet(), {"nothing", Bounds()}}), "");
  EXPECT_EQ(said({{"nothing", Bounds()}, {"none", Bounds()}}), "");
}

TEST(InputUnits, OfOneOfThreeIsNoticed)
{
  for (const double unit : {1000.0, 25.4})
  {
    const std::string factor = unit == 1000 ? "1000" : "25.4";
    const std::string inverse = unit == 1000 ? "0.001" : "1/25.4";
    EXPECT_TRUE(begins(said({walls(), inlet(1 / unit), outlet()}),
      "'inlet' seems to be in another unit: scale it by " + factor + ";"))
      << said({walls(), inlet(1 / unit), outlet()});
    EXPECT_TRUE(begins(said({walls(), inlet(), outlet(1 / unit)}),
      "'outlet' seems to be in another unit: scale it by " + factor + ";"));
    // A disc 25.4 times as large is not 20 times as large as the pipe.
    const std::string large = said({walls(), inlet(unit), outlet()});
    EXPECT_TRUE(unit == 25.4 ? large.empty()
                             : begins(large, "'inlet' seems to be in another unit: scale it by " +
                                               inverse + ";"))
      << large;
    EXPECT_TRUE(begins(said({walls(1 / unit), inlet(), outlet()}),
      "'walls' seems to be in another unit: scale it by " + factor + ";"));
    EXPECT_TRUE(begins(said({walls(unit), inlet(), outlet()}),
      "'walls' seems to be in another unit: scale it by " + inverse + ";"));
  }
  EXPECT_EQ(said({walls(), inlet(1e-3), outlet()}),
    "'inlet' seems to be in another unit: scale it by 1000; then the sides of its bounds fit the "
    "others; the diagonal of 'inlet' is 0.141, and the others' is 1.01e+03");
}

TEST(InputUnits, OfTwoInputsAreTheSmallerOnes)
{
  EXPECT_TRUE(begins(said({walls(), outlet(1e-3)}), "'outlet' seems"));
  EXPECT_TRUE(begins(said({outlet(1e-3), walls()}), "'outlet' seems"));
  EXPECT_TRUE(begins(said({walls(), inlet(1e-3), outlet(1e-3)}), "'walls' seems"))
    << "one of three";
}

TEST(InputUnits, OfSeveralInputsAreNamedTogether)
{
  const NamedBounds lid = input("lid", {0, 50, -50}, {1000, 50, 50});
  EXPECT_TRUE(begins(said({walls(), lid, input("left", {0, -50, -50}, {0, 50, 50}, 1e-3),
                       input("right", {1000, -50, -50}, {1000, 50, 50}, 1e-3)}),
    "'left', 'right' seem to be in another unit: scale them by 1000;"));
}

TEST(InputUnits, OfAWindowInOneSideAreNoticed)
{
  const NamedBounds hall = input("hall", {0, 0, 0}, {900, 500, 300});
  EXPECT_TRUE(
    begins(said({hall, input("window", {900, 100, 50}, {900, 200, 150}, 1e-3)}), "'window' seems"));
  EXPECT_EQ(said({hall, input("shelf", {880, 100, 50}, {880, 200, 150}, 1e-3)}), "");
  EXPECT_EQ(said({hall, input("outside", {900, 600, 50}, {900, 700, 150}, 1e-3)}), "");
}

TEST(InputUnits, OfBoltsAndFarFieldsAreNotNoticed)
{
  const NamedBounds ship = input("ship", {-20, -8, -3}, {120, 8, 30});
  EXPECT_EQ(said({ship, input("bolt", {3, 2, 1}, {3.02, 2.02, 1.1})}), "");
  EXPECT_EQ(said({ship, input("bolt at the origin", {0, 0, 0}, {0.02, 0.02, 0.1})}), "");
  EXPECT_EQ(said({ship, input("flag on top", {3, 2, 29.9}, {3.1, 2, 30})}), "");
  // The far field of a body is a multiple of its size, about the same middle.
  for (const double times : {20, 25, 50, 100})
  {
    EXPECT_EQ(said({input("body", {-1, -1, -1}, {1, 1, 1}),
                input("far field", {-1, -1, -1}, {1, 1, 1}, times)}),
      "")
      << times;
  }
}

TEST(InputUnits, OfRandomPartsAreHardlyEverNoticed)
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
  RecordProperty("alarms", alarms);
  EXPECT_LE(alarms, runs / 1000) << "of " << runs;
}

TEST(InputUnits, DoNotDependOnAUniformScale)
{
  for (const double scale : {1e-60, 1e-3, 1e60})
  {
    EXPECT_TRUE(begins(said({walls(scale), inlet(scale / 1000)}), "'inlet' seems")) << scale;
    EXPECT_EQ(said({walls(scale), inlet(scale)}), "") << scale;
  }
}
