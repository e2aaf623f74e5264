// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "diagnosis/Diagnosis.h"

#include "diagnosis/InsideOutAdvice.h"
#include "field/Field.h"
#include "support/Fields.h"
#include "support/Grids.h"
#include "support/Serial.h"
#include "support/Shapes.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{

using namespace shapes;
using winding::Field;
using winding::Grid;

Grid gridOver(const Point& low, const Point& high)
{
  return gridAround({low, high}, 12);
}

winding::Facing facingOf(const Field& field, const winding::SideCounts& sides)
{
  return field.diagnosis().facing(sides, winding::InsideTest(), serial);
}

/// Whether the source of a field looks inward by these sides.
bool looksInward(const Field& field, const winding::SideCounts& sides)
{
  return facingOf(field, sides).looksInward;
}

///@{
/// The sides of samples that nobody keeps the values of.
winding::SideCounts sidesOf(const Field& field, const Grid& grid, double threshold)
{
  winding::SideTally sides;
  winding::FieldOutput output;
  output.isInside.threshold = threshold;
  output.sides = &sides;
  field.evaluate(grid, grid.wholeExtent(), output, serial);
  return sides.counts(winding::sampleCount(grid.wholeExtent()));
}

winding::SideCounts sidesOf(
  const Field& field, const winding::VectorsView& samples, double threshold)
{
  winding::SideTally sides;
  winding::FieldOutput output;
  output.isInside.threshold = threshold;
  output.sides = &sides;
  field.evaluate(samples, output, serial);
  return sides.counts(samples.size());
}
///@}

/// A sample of −100 alone.
winding::SideCounts farBelow()
{
  winding::SideCounts sides;
  sides.add(-100, winding::InsideTest());
  return sides;
}

/// The same by the samples of a grid, by scattered samples, and by their values.
void expectInsideOut(const Field& field, const Grid& grid, bool expected, double threshold = 0.5)
{
  std::vector<Point> samples(winding::sampleCount(grid.wholeExtent()));
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    samples[n] = grid.sample(n);
  }
  const winding::VectorsView view(samples[0].data(), samples.size());
  std::vector<double> values(samples.size());
  winding::FieldOutput output;
  output.doubleValues = values.data();
  field.evaluate(view, output, serial);
  ASSERT_LT(*std::max_element(values.begin(), values.end()), 0.5) << "none may be inside";
  const winding::SideCounts sides =
    winding::countSides(values.size(), threshold, [&values](std::size_t i) { return values[i]; });
  EXPECT_EQ(looksInward(field, sidesOf(field, grid, threshold)), expected);
  EXPECT_EQ(looksInward(field, sidesOf(field, view, threshold)), expected);
  EXPECT_EQ(looksInward(field, sides), expected);
  EXPECT_EQ(sidesOf(field, view, threshold).negative, sides.negative);
  EXPECT_EQ(sidesOf(field, view, threshold).inside, sides.inside);
}

/// A sphere of points with normals inward.
Cloud inwardCloud()
{
  Cloud cloud = sphereCloud(500);
  for (Point& normal : cloud.normals)
  {
    normal = -normal;
  }
  return cloud;
}

} // namespace

TEST(Facing, IsASourceThatLooksInward)
{
  const Grid around = gridOver({-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2});
  const Mesh inward = icosphere(2).reversed();
  expectInsideOut(*fieldOf(inward), around, true);
  expectInsideOut(*fieldOf(inward.part(0, 250)), around, true); // open
  // All of this grid is in the solid, and none of it near a point of the cloud.
  const Grid within = gridOver({-0.4, -0.4, -0.4}, {0.4, 0.4, 0.4});
  expectInsideOut(*fieldOf(inward), within, true);
  expectInsideOut(*fieldOf(inwardCloud()), within, true);
}

TEST(Facing, IsNotASourceThatSamplesMiss)
{
  const Grid beside = gridOver({1.2, -1, -1}, {2, 1, 1});
  for (const Mesh& mesh : {icosphere(2), icosphere(2).reversed(), icosphere(2).part(0, 250)})
  {
    expectInsideOut(*fieldOf(mesh), beside, false);
  }
  const auto nothing = Field::build(std::vector<winding::TrianglesView>(), {}, serial);
  EXPECT_FALSE(looksInward(*nothing, sidesOf(*nothing, beside, 0.5)));
  const auto ball = fieldOf(icosphere(2));
  EXPECT_FALSE(looksInward(*ball, sidesOf(*ball, winding::VectorsView(), 0.5)));
}

TEST(Facing, IsNoSolidThatIsInsideOfAllItsSamples)
{
  const auto field = fieldOf(icosphere(2));
  const Grid inner = gridOver(Point(-0.1, -0.1, -0.1), Point(0.1, 0.1, 0.1));
  EXPECT_EQ(sidesOf(*field, inner, 0.5).negative, 0u);
}

TEST(Facing, IsNotAnOutwardCloudWhosePointsAreNearSamples)
{
  // A little before its points, w is far below −0.5.
  const Cloud cloud = sphereCloud(500);
  std::vector<Point> before;
  for (const Point& position : cloud.positions)
  {
    before.push_back(1.002 * position);
  }
  const auto field = fieldOf(cloud);
  const winding::VectorsView samples(before[0].data(), before.size());
  EXPECT_FALSE(looksInward(*field, sidesOf(*field, samples, 0.5)));
  EXPECT_FALSE(looksInward(*field, farBelow()));
  EXPECT_TRUE(looksInward(*fieldOf(inwardCloud()), farBelow()));
}

TEST(Facing, IsNoSetOfOpenSheets)
{
  // Three squares through each other: w is 0.5 and −0.5 at the sides of each, with 0 of the others.
  Mesh sheets;
  for (int axis = 0; axis < 3; ++axis)
  {
    Mesh square;
    for (const auto& [u, v] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
    {
      Point corner = Point::Zero();
      corner[(axis + 1) % 3] = u;
      corner[(axis + 2) % 3] = v;
      square.points.push_back(corner);
    }
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    sheets = sheets.with(square);
  }
  const auto field = fieldOf(sheets);
  EXPECT_FALSE(field->info().openings.areWide()) << field->info().openings.share; // measured: 0.577
  winding::SideCounts sides;
  sides.samples = 100;
  sides.negative = sides.inside = 4;
  ASSERT_TRUE(facingOf(*field, sides).warning);
  EXPECT_EQ(facingOf(*field, sides).warning->fault, winding::openSheetsAdvice("parts", {}).fault);
  const auto box = fieldOf(openCube().reversed());
  EXPECT_TRUE(looksInward(*box, sides));
}

TEST(Facing, IsASurfaceOfWhichAHundredthIsNegative)
{
  const auto field = fieldOf(icosphere(1));
  const auto looksInwardWith = [&field](std::size_t negative, std::size_t inside)
  {
    winding::SideCounts sides;
    sides.samples = 1'000'000;
    sides.negative = negative;
    sides.inside = inside;
    return looksInward(*field, sides);
  };
  EXPECT_TRUE(looksInwardWith(10, 990));
  EXPECT_FALSE(looksInwardWith(9, 991));
  EXPECT_TRUE(looksInwardWith(1, 99));
  EXPECT_FALSE(looksInwardWith(1, 198)) << "a two-hundredth is less";
  EXPECT_TRUE(looksInwardWith(1, 0));
  EXPECT_FALSE(looksInwardWith(0, 0));
}

TEST(Facing, NeedsAThresholdAboveZero)
{
  const Mesh inward = icosphere(2).reversed();
  const Grid around = gridOver({-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2});
  expectInsideOut(*fieldOf(inward), around, false, 0);
  expectInsideOut(*fieldOf(inward), around, false, -0.5);
  expectInsideOut(*fieldOf(inward), around, false, 1.5); // two solids through each other
  expectInsideOut(*fieldOf(inward.with(inward)), around, true, 1.5);
}
