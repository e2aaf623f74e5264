// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/Executor.h"
#include "base/Views.h"
#include "support/FarFields.h"
#include "support/Serial.h"
#include "support/ShuffledThreads.h"

#include <cmath>

/**
 * Far fields count all the work that they did, and the same for any executor.
 */

namespace
{

using namespace shapes;
using winding::Extent;
using winding::FarField;
using winding::FarFieldAccuracy;
using winding::FarFieldWork;
using winding::Grid;

struct Case
{
  std::string name;
  FarField field;
  Grid grid;
};

std::vector<Case> someCases()
{
  std::vector<Case> cases;
  for (const double tolerance : {1e-2, 1e-5})
  {
    for (const bool isCloud : {false, true})
    {
      const auto source =
        isCloud ? farSource(randomCloud(3000, 321)) : farSource(icosphere(3).part(0, 900));
      cases.push_back({(isCloud ? "cloud " : "triangles ") + std::to_string(tolerance),
        FarField(source->sources(), FarFieldAccuracy::of(tolerance), serial),
        shapes::gridAround(source->bounds(), {61, 37, 50}, 0.1)});
    }
  }
  return cases;
}

FarFieldWork workOn(const Case& one, const Extent& extent, winding::Executor& executor)
{
  std::vector<float> values(winding::sampleCount(extent));
  winding::FieldOutput output;
  output.values = values.data();
  FarFieldWork work;
  one.field.evaluate(one.grid, extent, output, executor, &work);
  return work;
}

FarFieldWork workAt(
  const FarField& field, const std::vector<Point>& samples, winding::Executor& executor)
{
  std::vector<float> values(samples.size());
  winding::FieldOutput output;
  output.values = values.data();
  FarFieldWork work;
  field.evaluate(winding::VectorsView(samples[0].data(), samples.size()), output, executor, &work);
  return work;
}

} // namespace

TEST(FarFieldWork, IsTheSameOnAnyThreads)
{
  for (const Case& one : someCases())
  {
    SCOPED_TRACE(one.name);
    const FarFieldWork expected = workOn(one, one.grid.wholeExtent(), serial);
    ShuffledThreads threads(7);
    EXPECT_TRUE(workOn(one, one.grid.wholeExtent(), threads) == expected);
    const std::vector<Point> samples = randomPoints(5000, -1.5, 1.5, 5);
    EXPECT_TRUE(workAt(one.field, samples, threads) == workAt(one.field, samples, serial));
  }
}

TEST(FarFieldWork, DeliversEverySampleOnce)
{
  for (const Case& one : someCases())
  {
    SCOPED_TRACE(one.name);
    for (const Extent& extent : {one.grid.wholeExtent(), Extent{0, 60, 11, 11, 0, 49},
           Extent{1, 58, 7, 30, 2, 45}, Extent{17, 17, 18, 18, 19, 19}})
    {
      EXPECT_EQ(workOn(one, extent, serial).samples(), winding::sampleCount(extent));
    }
    EXPECT_EQ(workAt(one.field, randomPoints(5000, -1.5, 1.5, 5), serial).samples(), 5000u);
  }
}

TEST(FarFieldWork, AddsUp)
{
  for (const Case& one : someCases())
  {
    SCOPED_TRACE(one.name);
    const FarFieldWork work = workOn(one, one.grid.wholeExtent(), serial);
    for (const auto count : winding::farFieldCounts)
    {
      if (count != &FarFieldWork::blockSamples && count != &FarFieldWork::rowSamples &&
          count != &FarFieldWork::rows)
      {
        EXPECT_GT(work.*count, 0u) << &count - winding::farFieldCounts;
      }
    }
    EXPECT_EQ(work.cells, work.shifts + 1) << "all but the root have a parent";
    EXPECT_LT(work.leaves, work.cells);
    EXPECT_LE(work.nearLeaves, work.leaves);
    EXPECT_LE(work.receivers, work.translationBatches);
    EXPECT_LE(work.translationBatches, work.translations);
    EXPECT_LE(work.translations, work.nodeTests) << "no node is accepted without a test";
    EXPECT_LE(work.exactSamples, work.nearSamples);
    EXPECT_GE(work.exactPairs, work.exactSamples);
  }
}

/// Node counts tell the angle of acceptance θ and the estimates of errors: no value would show that
/// they are too careless by some per cent, for tolerances are kept with room to spare.
TEST(FarFieldWork, IsThatOfTheParametersOfEachTolerance)
{
  struct Expected
  {
    double tolerance;
    double translations, momentValues, exactPairs;
    double exactPairsOfStrong;
  };
  const Expected table[] = {{1e-2, 186678, 794368, 24634560, 16364488},
    {1e-3, 262716, 320, 43774656, 21661056}, {1e-4, 795803, 704, 82080520, 35003488},
    {1e-5, 456902, 3712, 85713728, 33847760}, {1e-6, 451031, 2112, 88180672, 38439496}};
  const auto workWith = [&](const FarSource& source, int voxels, const FarFieldAccuracy& accuracy)
  {
    const Case one = {"", FarField(source.sources(), accuracy, serial),
      shapes::gridAround(source.bounds(), {voxels, voxels, voxels}, 0.1)};
    return workOn(one, one.grid.wholeExtent(), serial);
  };
  // Rounding of other instruction sets moves the border between near and far a little.
  const auto isNear = [](std::uint64_t found, double known)
  {
    return std::abs(static_cast<double>(found) - known) <= 0.005 * known;
  };
  const auto source = farSource(randomCloud(20000, 322));
  // Where points have a hundred times the area, the estimates of errors decide, not θ.
  const auto strong = farSource(randomCloud(5000, 322), 10);
  for (const Expected& expected : table)
  {
    SCOPED_TRACE(expected.tolerance);
    const FarFieldAccuracy accuracy = FarFieldAccuracy::of(expected.tolerance);
    const FarFieldWork work = workWith(*source, 48, accuracy);
    EXPECT_TRUE(isNear(work.translations, expected.translations)) << work.translations;
    EXPECT_TRUE(isNear(work.momentValues, expected.momentValues)) << work.momentValues;
    EXPECT_TRUE(isNear(work.exactPairs, expected.exactPairs)) << work.exactPairs;
    FarFieldAccuracy careless = accuracy;
    careless.theta *= 1.05f;
    EXPECT_FALSE(isNear(workWith(*source, 48, careless).translations, expected.translations))
      << "5 % more would not show";
    const FarFieldWork ofStrong = workWith(*strong, 32, accuracy);
    EXPECT_TRUE(isNear(ofStrong.exactPairs, expected.exactPairsOfStrong)) << ofStrong.exactPairs;
    careless = accuracy;
    careless.epsilon *= 1.1f;
    EXPECT_FALSE(isNear(workWith(*strong, 32, careless).exactPairs, expected.exactPairsOfStrong))
      << "10 % more would not show";
  }
}

TEST(FarFieldWork, IsNoneOverSourcesWithoutSources)
{
  const Case empty = {"",
    FarField(farSource(Cloud())->sources(), FarFieldAccuracy::of(1e-3), serial),
    gridOf({-1, -1, -1}, {0.1, 0.1, 0.1}, {19, 20, 21})};
  const FarFieldWork work = workOn(empty, empty.grid.wholeExtent(), serial);
  EXPECT_EQ(work.samples(), 19u * 20 * 21);
  EXPECT_EQ(work.nodeTests + work.translations + work.nearLeaves, 0u);
}
