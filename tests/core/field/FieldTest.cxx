// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "field/Field.h"

#include "base/Executor.h"
#include "base/Refusal.h"
#include "base/Views.h"
#include "cloud/PointAreas.h"
#include "sums/ReferenceSum.h"
#include "support/Fields.h"
#include "support/Grids.h"
#include "support/Interruption.h"
#include "support/Serial.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

namespace
{

using namespace shapes;
using winding::Extent;
using winding::Field;
using winding::FieldOutput;
using winding::Grid;
using winding::Method;

Grid someGrid()
{
  return gridAround({Point(-1.5, -1.4, -1.3), Point(1.5, 1.4, 1.3)}, 21);
}

std::vector<std::shared_ptr<const Field>> someFields()
{
  return {fieldOf(icosphere(2).part(0, 250)), fieldOf(icosphere(2).part(0, 250), Method::direct),
    fieldOf(torus(24, 12)), fieldOf(torus(24, 12), Method::parity), fieldOf(sphereCloud(300))};
}

} // namespace

TEST(Field, HasTheSameBitsInAnyPieces)
{
  const Grid grid = someGrid();
  const Extent whole = grid.wholeExtent();
  for (const auto& field : someFields())
  {
    const std::vector<double> expected = valuesOn(*field, grid, whole, serial);
    for (const Extent& piece : {Extent{0, 20, 0, 19, 7, 7}, Extent{3, 3, 0, 19, 0, 18},
           Extent{1, 17, 2, 11, 3, 13}, Extent{20, 20, 19, 19, 18, 18}})
    {
      const std::vector<double> values = valuesOn(*field, grid, piece, serial);
      for (std::size_t n = 0; n < values.size(); ++n)
      {
        ASSERT_EQ(
          values[n], expected[winding::sampleNumber(whole, winding::sampleIndex(piece, n))]);
      }
    }
  }
}

TEST(Field, HasTheSameBitsOnAnyThreadsInAnyOrder)
{
  SCOPED_TRACE("seeds 101, 102");
  const Grid grid = someGrid();
  ShuffledThreads one(101), other(102);
  for (const auto& field : someFields())
  {
    const std::vector<double> expected = valuesOn(*field, grid, grid.wholeExtent(), serial);
    EXPECT_EQ(valuesOn(*field, grid, grid.wholeExtent(), one), expected);
    EXPECT_EQ(valuesOn(*field, grid, grid.wholeExtent(), other), expected);
  }
}

TEST(Field, HasTheSameValuesAtScatteredSamples)
{
  const Grid grid = someGrid();
  const Extent extent = {2, 9, 3, 12, 5, 6};
  std::vector<Point> samples;
  std::vector<float> strided;
  for (std::size_t n = 0; n < winding::sampleCount(extent); ++n)
  {
    samples.push_back(grid.sample(extent, n));
  }
  for (const auto& field : someFields())
  {
    const std::vector<double> scattered = valuesAt(*field, samples);
    const std::vector<double> onGrid = valuesOn(*field, grid, extent, serial);
    if (field->info().method == Method::direct || field->info().method == Method::parity)
    {
      EXPECT_EQ(scattered, onGrid);
      continue;
    }
    const bool isExact = field->info().netBoundaryEdges == 0 && field->info().isSurface;
    for (std::size_t n = 0; n < samples.size(); ++n)
    {
      // The difference was measured as less than 1e-15 for exact fields, and as 5e-5 within the
      // tolerance.
      ASSERT_NEAR(scattered[n], onGrid[n], isExact ? 1e-13 : 1e-3);
    }
  }
}

TEST(Field, TakesSamplesOfAnyTypeAndStride)
{
  const auto field = fieldOf(icosphere(1));
  std::vector<float> strided;
  std::vector<Point> samples;
  for (int i = 0; i < 100; ++i)
  {
    // A float holds these numbers exactly.
    const float x = i / 64.0f - 0.75f, y = i % 7 / 8.0f, z = -i % 11 / 16.0f;
    strided.insert(strided.end(), {x, y, z, 77, 78});
    samples.push_back({x, y, z});
  }
  std::vector<double> values(100);
  FieldOutput output;
  output.doubleValues = values.data();
  field->evaluate(winding::VectorsView(strided.data(), 100, 5), output, serial);
  EXPECT_EQ(values, valuesAt(*field, samples));
}

TEST(Field, SaysWhenItWasInterrupted)
{
  Interruption interruption(0, 2);
  const Grid grid = someGrid();
  std::vector<float> values(winding::sampleCount(grid.wholeExtent()));
  FieldOutput output;
  output.values = values.data();
  EXPECT_THROW(fieldOf(cube())->evaluate(grid, grid.wholeExtent(), output, interruption),
    winding::Interrupted);
  const std::vector<Point> samples(1000, Point(0.5, 0.5, 0.5));
  EXPECT_THROW(fieldOf(cube())->evaluate(
                 winding::VectorsView(samples[0].data(), samples.size()), output, interruption),
    winding::Interrupted);
}

TEST(Field, DecidesInsideOnTheStoredValue)
{
  // The samples fill blocks, whose values compilers treat in a loop of their own.
  const auto field = fieldOf(openCube());
  const std::vector<Point> samples(1000, Point(0.5, 0.5, 0.5));
  const std::vector<double> exact = valuesAt(*field, samples);
  const winding::VectorsView view(samples[0].data(), samples.size());
  std::vector<float> floats(1000);
  std::vector<double> doubles(1000);
  std::vector<unsigned char> inside(1000);
  FieldOutput output;
  output.values = floats.data();
  output.inside = inside.data();
  field->evaluate(view, output, serial);
  ASSERT_NE(floats[0], exact[0]);
  output.isInside.threshold = 0.5 * (floats[0] + exact[0]);
  const bool floatIsInside = floats[0] > exact[0];
  field->evaluate(view, output, serial);
  EXPECT_EQ(inside, std::vector<unsigned char>(1000, floatIsInside));
  output.doubleValues = doubles.data();
  field->evaluate(view, output, serial);
  EXPECT_EQ(inside, std::vector<unsigned char>(1000, !floatIsInside));
  EXPECT_EQ(doubles, exact);
}

TEST(Field, AppliesTheInsideRule)
{
  const auto field = fieldOf(cube().reversed());
  const std::vector<Point> samples = {{0.5, 0.5, 0.5}, {2, 2, 2}};
  const winding::VectorsView view(samples[0].data(), samples.size());
  std::vector<unsigned char> inside(2);
  FieldOutput output;
  output.inside = inside.data();
  field->evaluate(view, output, serial);
  EXPECT_EQ(inside, (std::vector<unsigned char>{0, 0}));
  for (const auto rule : {winding::InsideRule::absoluteThreshold, winding::InsideRule::odd})
  {
    output.isInside.rule = rule;
    field->evaluate(view, output, serial);
    EXPECT_EQ(inside, (std::vector<unsigned char>{1, 0}));
  }
}
