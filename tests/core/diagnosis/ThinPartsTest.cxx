// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "diagnosis/ThinParts.h"

#include "diagnosis/Diagnosis.h"
#include "field/Field.h"
#include "support/Fields.h"
#include "support/Grids.h"
#include "support/Serial.h"
#include "support/Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace
{

using namespace shapes;
using winding::Extent;
using winding::Grid;
using winding::ThinParts;

Grid gridAround(const Mesh& mesh, int resolution)
{
  return shapes::gridAround(clean(mesh).bounds, resolution, 0.05);
}

std::optional<ThinParts> thinPartsOn(const Mesh& mesh, const Grid& grid, double threshold = 0.5)
{
  const auto field = fieldOf(mesh);
  const Extent extent = grid.wholeExtent();
  std::vector<unsigned char> inside(winding::sampleCount(extent));
  winding::FieldOutput output;
  output.inside = inside.data();
  output.isInside.threshold = threshold;
  field->evaluate(grid, extent, output, serial);
  return field->diagnosis().thinParts(
    grid, [&](int i, int j, int k) { return inside[winding::sampleNumber(extent, i, j, k)] != 0; },
    output.isInside, serial);
}

/// A hollow ball of radius 1.
Mesh shell(double thickness)
{
  const Mesh ball = icosphere(4);
  return ball.with(ball.reversed().mapped([&](const Point& p) { return (1 - thickness) * p; }));
}

} // namespace

TEST(ThinParts, SmallComponentsAreCounted)
{
  // Samples of this block lie at 0.05, 0.15 …; one of the three small cubes holds one.
  const auto small = [](double x)
  {
    return cube({x, 1.51, 0.51}, {x + 0.03, 1.54, 0.54});
  };
  const Mesh mesh = cube({0, 0, 0}, {1, 1, 1})
                      .with(cube({0, 1.9, 0.9}, {1, 2, 1}))
                      .with(small(0.51))
                      .with(small(0.71))
                      .with(cube({0.34, 1.54, 0.54}, {0.36, 1.56, 0.56}));
  Grid grid;
  grid.dimensions = {10, 20, 10};
  grid.firstSample = {0.05, 0.05, 0.05};
  grid.spacing = {0.1, 0.1, 0.1};
  const auto parts = thinPartsOn(mesh, grid);
  ASSERT_TRUE(parts);
  EXPECT_FALSE(parts->areWorthTelling());
  EXPECT_EQ(parts->components, 5u);
  EXPECT_EQ(parts->lostComponents, 2u);
  EXPECT_EQ(
    thinPartsAdvice(*parts, grid, false).facts, "2 of 5 closed parts have no sample inside");
}

TEST(ThinParts, AreLostBetweenSamples)
{
  // A voxel of the first grid is 0.07 wide.
  const Mesh thin = shell(0.02);
  const auto lost = thinPartsOn(thin, gridAround(thin, 32));
  ASSERT_TRUE(lost);
  EXPECT_NEAR(lost->lostShare, 0.24, 0.06);
  EXPECT_NEAR(lost->thinShare, 1, 0.05);
  // Voxels are √3 times as thick along their diagonals. Measured 0.0117.
  EXPECT_NEAR(lost->largestVoxel(), 0.02 / std::sqrt(3.0), 0.001);

  const winding::Message advice = thinPartsAdvice(*lost, gridAround(thin, 32), false);
  EXPECT_EQ(advice.fault, "parts are thinner than a voxel");
  EXPECT_NE(advice.facts.find("a resolution of 190 would keep it"), std::string::npos)
    << advice.facts;
  EXPECT_EQ(advice.remedies.size(), 1u);
  EXPECT_EQ(thinPartsAdvice(*lost, gridAround(thin, 32), true).remedies.size(), 2u);

  const auto kept = thinPartsOn(thin, gridAround(thin, 190));
  ASSERT_TRUE(kept);
  EXPECT_FALSE(kept->areWorthTelling()) << kept->thinShare;
}

TEST(ThinParts, AreNoneOfSolidsThatAreThickEnough)
{
  for (const Mesh& solid : {icosphere(3), cube(), torus(60, 30), shell(0.4), surfaceOf(lShape()),
         // walls inside of a solid
         cube().with(cube({0.3, 0.3, 0.3}, {0.7, 0.7, 0.7}))})
  {
    const auto parts = thinPartsOn(solid, gridAround(solid, 24));
    ASSERT_TRUE(parts);
    EXPECT_FALSE(parts->areWorthTelling()) << parts->thinShare; // measured: 0
  }
}

TEST(ThinParts, OfFewLargeTrianglesAreLostAmongManySmallOnes)
{
  // The plate has 12 triangles and the ball 81 920, or 327 680 of which not all are looked at.
  for (const int level : {6, 7})
  {
    SCOPED_TRACE(level);
    const Mesh ball = icosphere(level).moved({4, 4, 4});
    const Mesh plate = cube({0.03, 0.05, 0.07}, {9.7, 9.9, 0.13});
    const auto parts = thinPartsOn(plate.with(ball), gridAround(plate.with(ball), 40));
    ASSERT_TRUE(parts);
    EXPECT_TRUE(parts->areWorthTelling());
    // The plate has 94 % of the area. Measured 93 and 94 %.
    EXPECT_GT(std::max(parts->lostShare, parts->thinShare), 0.8);
  }
}

TEST(ThinParts, WhatBoundsNothingIsNotLost)
{
  Mesh sheet;
  sheet.points = {{0, 0, 0}, {1, 0, 0.3}, {1, 1, 0}, {0, 1, 0.2}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto parts = thinPartsOn(sheet, gridAround(sheet, 24));
  ASSERT_TRUE(parts);
  EXPECT_FALSE(parts->areWorthTelling()) << parts->thinShare;
}

TEST(ThinParts, WantASurface)
{
  const std::vector<double> points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  winding::OrientedPointsView view;
  view.positions = {points.data(), 4};
  view.normals = {points.data(), 4};
  winding::FieldOptions options;
  options.pointAreaMethod = winding::PointAreaMethod::constant;
  options.pointArea = 1;
  const auto cloud = winding::Field::build({view}, options, serial);
  const auto nothing = [](int, int, int)
  {
    return false;
  };
  EXPECT_FALSE(
    cloud->diagnosis().thinParts(gridAround(cube(), 8), nothing, winding::InsideTest(), serial));
}
