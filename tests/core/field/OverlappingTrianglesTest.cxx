// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/Executor.h"
#include "base/FieldOutput.h"
#include "base/Views.h"
#include "farfield/FarField.h"
#include "farfield/TriangleFarField.h"
#include "field/Field.h"
#include "source/Sanitize.h"
#include "support/Fields.h"
#include "support/HostileSoups.h"
#include "support/Interruption.h"
#include "support/Serial.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

/**
 * Triangles that overlap each other so much that most are near to every sample: no method does more
 * work than the direct sum, up to what is promised in Field.h, and all agree with it. Work is
 * counted here, and timed in SoupTimeTest.cxx.
 */

namespace
{

using namespace shapes;
using winding::Field;
using winding::FieldOutput;
using winding::Grid;
using winding::Method;

constexpr std::size_t triangles = 1500;

} // namespace

class OverlappingTriangles : public testing::TestWithParam<std::pair<std::string, Mesh>>
{
};

TEST_P(OverlappingTriangles, TakeNoMorePairsThanTheDirectSum)
{
  const winding::Surface surface = clean(GetParam().second);
  const winding::FarFieldAccuracy accuracy = winding::FarFieldAccuracy::of(1e-3);
  for (const int resolution : {10, 24, 40})
  {
    SCOPED_TRACE(resolution);
    const Grid grid = gridAround(surface.bounds, resolution);
    const winding::TriangleFarField farField(surface.vertices, surface, surface.bounds, accuracy);
    const std::size_t samples = winding::sampleCount(grid.wholeExtent());
    std::vector<float> values(samples);
    FieldOutput output;
    output.values = values.data();
    winding::FarFieldWork work;
    farField.suiting(grid, serial)->evaluate(grid, grid.wholeExtent(), output, serial, &work);
    EXPECT_LE(work.exactPairs, surface.triangles.size() * samples);
    // The nodes looked at cost some nanoseconds each, a pair one: all else is little against pairs.
    // There is one node for 18 pairs at most.
    EXPECT_LE(work.nodeTests + work.nearTests, surface.triangles.size() * samples / 16 + 100'000);
  }
}

TEST_P(OverlappingTriangles, TakeNoMoreVectorsThanTheDirectSumAtScatteredSamples)
{
  // Scattered samples are few in each cell. A vector of samples takes as long for one as for all.
  const winding::Surface surface = clean(GetParam().second);
  const winding::FarFieldAccuracy accuracy = winding::FarFieldAccuracy::of(1e-3);
  const winding::TriangleFarField farField(surface.vertices, surface, surface.bounds, accuracy);
  for (const std::size_t count : {300, 2000, 20000})
  {
    SCOPED_TRACE(count);
    const std::vector<Point> samples = randomPointsAround(surface.bounds, count, 0, 1, 77);
    const winding::VectorsView view(samples.data()->data(), count);
    std::vector<double> values(count);
    FieldOutput output;
    output.doubleValues = values.data();
    winding::FarFieldWork work;
    farField.suiting(view, serial)->evaluate(view, output, serial, &work);
    EXPECT_EQ(work.samples(), count);
    // Samples that are summed with others of their cell leave a vector half empty now and then.
    const double ofAll =
      static_cast<double>(work.exactLanes) / static_cast<double>(surface.triangles.size() * count);
    RecordProperty("shareOfVectors", std::to_string(ofAll));
    EXPECT_LE(ofAll, 1.05); // measured: 1.015
  }
}

TEST_P(OverlappingTriangles, TellOfAnInterruptAnywhere)
{
  // The samples of many cells get the sum of all triangles together, in a run of their own.
  const winding::Surface surface = clean(GetParam().second);
  const winding::FarFieldAccuracy accuracy = winding::FarFieldAccuracy::of(1e-3);
  const winding::TriangleFarField farField(surface.vertices, surface, surface.bounds, accuracy);
  const std::vector<Point> samples = randomPoints(300, 1, 15, 78);
  const winding::VectorsView view(samples.data()->data(), samples.size());
  std::vector<double> values(samples.size());
  FieldOutput output;
  output.doubleValues = values.data();
  const auto suiting = farField.suiting(view, serial);
  int runs = 0;
  for (bool wasInterrupted = true; wasInterrupted; ++runs)
  {
    Interruption executor(runs);
    const bool isComplete = isCompleted([&] { suiting->evaluate(view, output, executor); });
    wasInterrupted = executor.cameToPass();
    EXPECT_NE(isComplete, wasInterrupted) << "run " << runs;
  }
  EXPECT_GT(runs, 2);
}

TEST_P(OverlappingTriangles, HaveTheSameBitsInPiecesAndOnAnyThreads)
{
  // Cells are given up by the samples that they have in the whole grid, not in the piece.
  const auto field = fieldOf(GetParam().second, Method::hierarchical, false);
  const Grid grid = gridAround(field->info().bounds, 27);
  const std::vector<double> expected = valuesOn(*field, grid);
  std::vector<double> values(expected.size());
  winding::Extent extent = grid.wholeExtent();
  const auto layer = static_cast<std::size_t>(extent[1] + 1) * (extent[3] + 1);
  for (int k = 0; k < grid.dimensions[2]; k += 5)
  {
    ShuffledThreads threads(static_cast<unsigned>(k));
    extent[4] = k;
    extent[5] = std::min(k + 4, grid.dimensions[2] - 1);
    FieldOutput output;
    output.doubleValues = values.data() + layer * static_cast<std::size_t>(k);
    field->evaluate(grid, extent, output, threads);
  }
  EXPECT_EQ(values, expected);
}

TEST_P(OverlappingTriangles, HaveTheirValuesByEveryMethod)
{
  const Mesh& mesh = GetParam().second;
  std::size_t compared = 0, all = 0;
  for (const int resolution : {9, 20})
  {
    const Grid grid = gridAround(clean(mesh).bounds, resolution);
    const auto direct = fieldOf(mesh, Method::direct, false);
    const std::vector<double> expected = valuesOn(*direct, grid);
    for (const Method method : {Method::automatic, Method::rows, Method::hierarchical})
    {
      const std::vector<double> values = valuesOn(*fieldOf(mesh, method, false), grid);
      for (std::size_t i = 0; i < expected.size(); ++i)
      {
        ++all;
        // Samples on triangles, which a lattice has many of, may have the value of any side.
        if (std::abs(values[i] - expected[i]) > 1e-3)
        {
          ASSERT_GT(direct->jumpWithin(grid.sample(i), 1e-9), 0)
            << winding::nameOf(method) << " sample " << i;
          continue;
        }
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, all / 10 * 7); // measured: 73 % to 100 %
  const std::vector<Point> samples = randomPoints(500, -1, 17, 1520);
  const std::vector<double> expected = valuesAt(*fieldOf(mesh, Method::direct, true), samples);
  for (const Method method : {Method::automatic, Method::hierarchical})
  {
    const std::vector<double> values = valuesAt(*fieldOf(mesh, method, true), samples);
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      ASSERT_NEAR(values[i], expected[i], 1e-3) << winding::nameOf(method) << " sample " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, OverlappingTriangles, testing::ValuesIn(hostileSoups(triangles)),
  [](const auto& param)
  {
    std::string name = param.param.first;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
  });

TEST(EqualTriangles, AreSummedOnce)
{
  for (const Method method : {Method::automatic, Method::hierarchical, Method::rows})
  {
    const auto field = fieldOf(copiesOf(icosphere(1).part(0, 60), 50), method, false);
    EXPECT_EQ(field->info().primitives, 3000u);
    EXPECT_EQ(field->info().distinct, 60u);
    EXPECT_LE(field->info().capTriangles, 60u);
    EXPECT_EQ(field->surface()->triangles.size(), 3000u);
    EXPECT_EQ(field->distinctSurface()->triangles.size(), 60u);
  }
}

TEST(EqualTriangles, AreFoundWhicheverWayTheyRun)
{
  Mesh two{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 2}}};
  do
  {
    two.triangles[1] = two.triangles[0];
    EXPECT_EQ(fieldOf(two, Method::automatic, false)->info().distinct, 1u);
  } while (std::next_permutation(two.triangles[0].begin(), two.triangles[0].end()));
}

TEST(EqualTriangles, CancelOppositeOnes)
{
  const Mesh mesh = icosphere(1).part(0, 50);
  const auto field = fieldOf(copiesOf(mesh.with(mesh.reversed()), 3), Method::automatic, false);
  EXPECT_EQ(field->info().netBoundaryEdges, 0u);
  for (const double w : valuesOn(*field, gridAround(field->info().bounds, 11)))
  {
    ASSERT_EQ(w, 0);
  }
}

TEST(EqualTriangles, OfAClosedSurfaceGiveMultiplesOnGridsAndScattered)
{
  const Mesh mesh = icosphere(2);
  const auto once = fieldOf(mesh, Method::automatic, false);
  const auto thrice = fieldOf(copiesOf(mesh, 3), Method::automatic, false);
  EXPECT_EQ(thrice->info().method, Method::rows);
  const Grid grid = gridAround(once->info().bounds, 15);
  const std::vector<double> expected = valuesOn(*once, grid), values = valuesOn(*thrice, grid);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    ASSERT_EQ(values[i], 3 * expected[i]);
  }
  std::vector<Point> samples = randomPoints(300, -1.2, 1.2, 1530);
  for (int i = 0; i < 100; ++i) // rays on one line are counted in a way of their own
  {
    samples.emplace_back(-1.2 + 0.024 * i, 0.123, 0.234);
  }
  const std::vector<double> scattered = valuesAt(*once, samples);
  const std::vector<double> scatteredThrice =
    valuesAt(*fieldOf(copiesOf(mesh, 3), Method::automatic, true), samples);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    ASSERT_EQ(scatteredThrice[i], 3 * scattered[i]);
  }
}
