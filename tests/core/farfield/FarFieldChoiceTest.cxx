// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/FarFieldChoice.h"
#include "support/HostileSoups.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using winding::Primitive;
using winding::SampledSource;

SampledSource sourceOf(std::size_t triangles, std::size_t samples, double area)
{
  return {Primitive::triangle, triangles, samples, area};
}

TEST(FarFieldChoice, SumsFewPrimitivesAndFewSamplesDirectly)
{
  for (const Primitive kind : {Primitive::triangle, Primitive::point})
  {
    EXPECT_TRUE(winding::isCheaperDirectly(kind, 1, 5));
    EXPECT_TRUE(winding::isCheaperDirectly(kind, 10, 5));
    EXPECT_FALSE(winding::isCheaperDirectly(kind, 100, 5)) << "measured: from 27 and 37 on";
    EXPECT_FALSE(winding::isCheaperDirectly(kind, 1'000'000, 9));
    EXPECT_TRUE(winding::isCheaperDirectly(kind, 1'000'000, 10, 5)) << "ten samples need no tree";
    EXPECT_FALSE(winding::isCheaperDirectly(kind, 1'000'000, 100'000, 5));
    EXPECT_FALSE(winding::isCheaperDirectly(kind, 1'000'000, 10, 5, winding::FarFieldState::built));
    EXPECT_TRUE(winding::isCheaperDirectly(kind, 100, 10, 5, winding::FarFieldState::built));
  }
}

TEST(FarFieldChoice, BuildsATreeForASoupOnlyWhereThatTakesLittle)
{
  using winding::FarFieldGain;
  using winding::FarFieldState;
  const auto isDirect = [](std::size_t samples, FarFieldGain gain)
  {
    return winding::isCheaperDirectly(
      Primitive::triangle, 50'000, samples, 5, FarFieldState::toBuild, gain);
  };
  EXPECT_FALSE(isDirect(1000, FarFieldGain::likely));
  EXPECT_TRUE(isDirect(1000, FarFieldGain::doubtful)) << "measured: the tree takes 0.4 of the sum";
  EXPECT_FALSE(isDirect(3000, FarFieldGain::doubtful));
}

TEST(FarFieldChoice, DoubtsTheGainOfLargeTriangles)
{
  const auto gainOf = [](const shapes::Mesh& mesh)
  {
    const winding::Surface surface = shapes::clean(mesh);
    return winding::gainOfFarField(surface.vertices, surface.triangles, surface.bounds);
  };
  const shapes::Mesh sphere = shapes::icosphere(4);
  EXPECT_EQ(gainOf(sphere), winding::FarFieldGain::likely);
  EXPECT_EQ(gainOf(shapes::latticeSoup(1000, 17, 1)), winding::FarFieldGain::doubtful);
  EXPECT_EQ(gainOf(shapes::needlesOf(1000, 2)), winding::FarFieldGain::doubtful);
  EXPECT_EQ(gainOf(sphere.with(shapes::latticeSoup(1700, 3, 3))), winding::FarFieldGain::likely)
    << "a quarter of 6820 would be 1705";
}

TEST(FarFieldChoice, WeighsTheDirectSumByItsTerms)
{
  const double one = winding::weightOfDirectSum(1000, 1000);
  EXPECT_NEAR(winding::weightOfDirectSum(10'000, 1000), 10 * one, 0.01 * one);
  EXPECT_NEAR(winding::weightOfDirectSum(1000, 10'000), 10 * one, 0.01 * one);
}

TEST(FarFieldChoice, WeighsTheTreeTheSamplesAndThoseNearTheSource)
{
  // Many triangles at few samples weigh as much as a tree, whatever the area.
  const double tree = winding::weightOfFarField(sourceOf(1'000'000, 10, 10), 5);
  EXPECT_NEAR(winding::weightOfFarField(sourceOf(10'000'000, 10, 10), 5), 10 * tree, 0.2 * tree);
  // An area twice as large has twice as many samples near it.
  const auto near = [](double area)
  {
    return winding::weightOfFarField(sourceOf(100'000, 100'000, area), 5) -
           winding::weightOfFarField(sourceOf(100'000, 100'000, 0), 5);
  };
  EXPECT_NEAR(near(20'000), 2 * near(10'000), 1e-6 * near(10'000));
  // No sample is near to more triangles than there are.
  const SampledSource two = sourceOf(2, 1'000'000, 1e9);
  EXPECT_LT(winding::weightOfFarField(two, 5), 100 * winding::weightOfDirectSum(2, 1'000'000));
  EXPECT_EQ(
    winding::weightOfFarField(two, 5), winding::weightOfFarField(sourceOf(2, 1'000'000, 1e10), 5));
  double before = 0;
  for (const int order : {3, 5, 7, 9})
  {
    const double weight = winding::weightOfFarField(sourceOf(10'000, 1'000'000, 25'000), order);
    EXPECT_GT(weight, before);
    before = weight;
  }
}

} // namespace
