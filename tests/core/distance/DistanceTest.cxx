// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "field/Field.h"

#include "base/Views.h"
#include "support/FieldDistances.h"
#include "support/Grids.h"
#include "support/NaiveDistance.h"
#include "support/Serial.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

/**
 * Signed distances of grids and of scattered samples, as fields give them.
 */
namespace
{

using namespace shapes;
using winding::Extent;
using winding::Field;
using winding::FieldOutput;
using winding::Grid;
using winding::sampleCount;
using winding::sampleIndex;
using winding::sampleNumber;

/// Relative errors stay below this; the largest one measured is 1.3e-12.
constexpr double rounding = 1e-10;
Grid gridOver(const Point& low, const Point& high, const Eigen::Vector3i& dimensions)
{
  return gridAround({low, high}, dimensions);
}

/// Compares signs with sides, and returns the largest relative error against the naive distance.
template <class Source>
double checkAll(const Distances& found, const std::vector<Point>& samples, const Source& source)
{
  double worst = 0;
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    const double expected = naiveDistance(samples[n], source);
    const double error =
      expected == 0 ? found.distances[n] : std::abs(found.distances[n]) / expected - 1;
    worst = std::max(worst, std::abs(error));
    EXPECT_EQ(found.distances[n] < 0, found.inside[n] == 1 && found.distances[n] != 0) << n;
  }
  return worst;
}

struct NamedMesh
{
  std::string name;
  Mesh mesh;
};

std::vector<NamedMesh> someMeshes()
{
  return {{"tetrahedron", tetrahedron()}, {"cube", cube()}, {"open cube", openCube()},
    {"sphere", icosphere(3)}, {"part of a sphere", icosphere(2).part(0, 200)},
    {"torus", torus(40, 20)}, {"strip", moebiusStrip(30)}, {"soup", triangleSoup(700, 811)},
    {"a triangle", tetrahedron().part(0, 1)},
    {"far apart", icosphere(1).with(icosphere(1).mapped(
                    [](const Point& p) { return Point(1e3 + p[0], p[1], p[2]); }))},
    {"flat", torus(30, 10).mapped([](const Point& p) { return Point(p[0], p[1], 0); })}};
}

/// Grids of cubic voxels and of others, of one sample, a plane and a line of samples; larger than
/// the sources, small near their surface, and far away.
std::vector<Grid> someGrids()
{
  const Point low(-1.6, -1.5, -1.4), high(1.3, 1.5, 1.7);
  return {gridOver(low, high, {11, 13, 12}), gridOver(low, high, {40, 3, 11}),
    gridOver(low, high, {1, 1, 1}), gridOver(low, high, {1, 33, 20}),
    gridOver(low, high, {1, 1, 67}), gridOver(4 * low, 5 * high, {9, 9, 9}),
    gridOver(Point(0.99, 0, 0), Point(1.01, 0.02, 0.03), {12, 12, 12}),
    gridOver(Point(1e6, 0, 0), Point(1e6 + 1, 1, 1), {5, 5, 5})};
}

} // namespace

TEST(Distance, GridsAndScatteredSamplesHaveTheNaiveDistance)
{
  SCOPED_TRACE("seed 811");
  double worst = 0;
  for (const auto& [name, mesh] : someMeshes())
  {
    const auto field = fieldOf(mesh);
    for (const Grid& grid : someGrids())
    {
      SCOPED_TRACE(name + " over " + std::to_string(grid.dimensions[0]) + " along x");
      const std::vector<Point> samples = samplesOf(grid);
      const double error = std::max(checkAll(evaluate(*field, grid), samples, mesh),
        checkAll(evaluate(*field, samples), samples, mesh));
      EXPECT_LT(error, rounding);
      worst = std::max(worst, error);
    }
  }
  record("largest relative error", worst);
}

TEST(Distance, OfCloudsIsThatOfTheirNearestPoint)
{
  SCOPED_TRACE("seed 812");
  Cloud one = randomCloud(1, 812);
  Cloud equal = randomCloud(1, 812);
  equal.positions.resize(50, equal.positions[0]);
  equal.normals.resize(50, equal.normals[0]);
  for (const Cloud& cloud : {sphereCloud(900), randomCloud(2000, 812), one, equal})
  {
    const auto field = fieldOf(cloud);
    for (const Grid& grid : someGrids())
    {
      const std::vector<Point> samples = samplesOf(grid);
      EXPECT_LT(checkAll(evaluate(*field, grid), samples, cloud.positions), rounding);
      EXPECT_LT(checkAll(evaluate(*field, samples), samples, cloud.positions), rounding);
    }
  }
}

TEST(Distance, OfASampleDoesNotDependOnTheOthers)
{
  SCOPED_TRACE("seeds 71 … 73");
  // Needles of all widths, with sides of up to 1, stand among triangles of all sizes.
  Random random(71);
  Mesh needles;
  for (int i = 0; i < 300; ++i)
  {
    const Point at = random.point(-1, 1), along = random.direction() * random(0, 1);
    const Point aside = random.direction() * std::pow(10.0, random(-17, 0));
    const auto first = static_cast<int>(needles.points.size());
    needles.points.insert(needles.points.end(), {at, at + along, at + 0.3 * along + aside});
    needles.triangles.push_back({first, first + 1, first + 2});
  }
  std::vector<std::shared_ptr<const Field>> fields = {
    fieldOf(needles), fieldOf(icosphere(3)), fieldOf(sphereCloud(2000)), fieldOf(cube())};
  for (const std::shared_ptr<const Field>& field : fields)
  {
    std::vector<Point> samples = randomPoints(3000, -1.3, 1.3, 72);
    Random sizes(73);
    for (const Point& vertex : needles.points)
    {
      samples.push_back(vertex);
      samples.push_back(vertex + sizes.direction() * std::pow(10.0, sizes(-17, 0)));
    }
    for (int i = 0; i < 300; ++i)
    {
      samples.emplace_back(0, 0, 0);
      samples.push_back(sizes.direction() * std::pow(10.0, sizes(0, 9)));
      samples.push_back(sizes.direction() * std::pow(10.0, sizes(-9, 0)));
    }
    for (const double limit : {infinite, 0.1})
    {
      const Distances together = evaluate(*field, samples, limit);
      std::vector<Point> reversed(samples.rbegin(), samples.rend());
      const Distances turned = evaluate(*field, reversed, limit);
      for (std::size_t n = 0; n < samples.size(); ++n)
      {
        ASSERT_EQ(together.distances[n], turned.distances[samples.size() - 1 - n]) << n;
      }
      // So few samples are searched for one by one.
      for (std::size_t n = 0; n + 5 <= samples.size(); n += 10)
      {
        const auto first = samples.begin() + static_cast<std::ptrdiff_t>(n);
        const Distances few = evaluate(*field, std::vector<Point>(first, first + 5), limit);
        for (std::size_t i = 0; i < 5; ++i)
        {
          ASSERT_EQ(together.distances[n + i], few.distances[i]) << n + i;
        }
      }
    }
  }
}

TEST(Distance, OfFewSamplesIsThatOfMany)
{
  SCOPED_TRACE("seeds 74, 75");
  const std::vector<std::shared_ptr<const Field>> fields = {
    fieldOf(icosphere(5)), fieldOf(triangleSoup(20'000, 74)), fieldOf(sphereCloud(20'000))};
  // Beside samples everywhere there are many in a small region, equal ones, and two without a
  // place.
  std::vector<Point> some = randomPoints(4000, -1.3, 1.3, 75);
  for (std::size_t n = 0; n < 2000; ++n)
  {
    some.push_back(Point(0.9, 0.1, 0) + 1e-3 * some[n]);
    some.push_back(some[7]);
  }
  some.emplace_back(std::nan(""), 0, 0);
  some.emplace_back(0, infinite, 0);
  std::vector<Point> many = some;
  for (int copy = 0; copy < 3; ++copy)
  {
    many.insert(many.end(), some.begin(), some.end());
  }
  for (const std::shared_ptr<const Field>& field : fields)
  {
    for (const double limit : {infinite, 0.05})
    {
      // Fewer samples than triangles or points are searched for one by one; more share cells.
      const Distances few = evaluate(*field, some, limit), all = evaluate(*field, many, limit);
      const std::vector<Point> reversed(some.rbegin(), some.rend());
      const Distances turned = evaluate(*field, reversed, limit);
      for (std::size_t n = 0; n + 2 < some.size(); ++n)
      {
        ASSERT_EQ(few.distances[n], all.distances[n]) << n;
        ASSERT_EQ(few.distances[n], turned.distances[some.size() - 1 - n]) << n;
      }
      EXPECT_TRUE(std::isnan(few.distances[some.size() - 2]));
      EXPECT_TRUE(std::isnan(few.distances[some.size() - 1]));
    }
  }
}

TEST(Distance, CloseSamplesAreAsExact)
{
  SCOPED_TRACE("seed 813");
  for (const auto& [name, mesh] : someMeshes())
  {
    SCOPED_TRACE(name);
    const auto field = fieldOf(mesh);
    for (const double distance : {1e-3, 1e-6, 1e-9})
    {
      const std::vector<Point> samples = pointsNear(mesh, 300, distance, 813);
      // Positions are rounded: to 1e-16 where they are about 1, and to 1e-13 in the mesh far apart.
      const double limit = 3e-13 / distance;
      const Distances found = evaluate(*field, samples);
      for (std::size_t n = 0; n < samples.size(); ++n)
      {
        const double expected = naiveDistance(samples[n], mesh);
        EXPECT_NEAR(std::abs(found.distances[n]), expected, limit * distance);
      }
    }
  }
}

TEST(Distance, GridsMuchFinerThanTheTrianglesBesideThemAreAsExact)
{
  SCOPED_TRACE("seed 816");
  Random random(816);
  double worst = 0;
  for (const double origin : {0.0, 1e3})
  {
    for (double spacing = 1e-2; spacing > 0.5e-8; spacing *= 0.1)
    {
      for (int i = 0; i < 60; ++i)
      {
        Mesh mesh = tetrahedron();
        for (Point& p : mesh.points)
        {
          p = Point::Constant(origin) + random.point(-1, 1);
        }
        // The grids lie about a vertex, a point of an edge and a point of a face in turn.
        const std::size_t corner = random.bits() % 4;
        const Point& a = mesh.points[corner];
        const Point u = mesh.points[(corner + 1) % 4] - a, v = mesh.points[(corner + 2) % 4] - a;
        const double along = i % 3 == 0 ? 0 : random(0, 1);
        const Point at = a + along * u + (i % 3 == 2 ? random(0, 1 - along) : 0) * v;
        Grid grid;
        grid.dimensions = {13, 12, 11};
        grid.spacing = Point::Constant(spacing);
        grid.firstSample = at - spacing * (Point::Constant(6) + random.point(-1, 1));
        const auto field = fieldOf(mesh);
        const std::vector<Point> samples = samplesOf(grid);
        for (const double limit : {infinite, 3.3 * spacing})
        {
          const Distances found = evaluate(*field, grid, grid.wholeExtent(), limit);
          for (std::size_t n = 0; n < samples.size(); ++n)
          {
            const double expected = std::min(limit, naiveDistance(samples[n], mesh));
            const double error =
              std::abs(std::abs(found.distances[n]) - expected) / (1 + expected / rounding);
            ASSERT_LT(error, 1e-15) // measured: 1.4e-16
              << "tetrahedron " << i << " at " << origin << ", spacing " << spacing << ", sample "
              << n << ", limit " << limit;
            worst = std::max(worst, error);
          }
        }
      }
    }
  }
  record("largest error", worst);
}

TEST(Distance, CloudsMuchLargerThanAGridAreAsExact)
{
  SCOPED_TRACE("seed 817");
  Random random(817);
  for (const double origin : {0.0, 1e3})
  {
    for (double spacing = 1e-2; spacing > 0.5e-8; spacing *= 0.1)
    {
      for (unsigned i = 0; i < 10; ++i)
      {
        // Half of the points are as close to each other as the samples are.
        Cloud cloud = randomCloud(60, 817 + i);
        for (std::size_t n = 0; n < 60; ++n)
        {
          const Point near = cloud.positions[0] + 3 * spacing * random.direction();
          cloud.positions[n] = Point::Constant(origin) + (n % 2 ? near : cloud.positions[n]);
        }
        Grid grid;
        grid.dimensions = {13, 12, 11};
        grid.spacing = Point::Constant(spacing);
        grid.firstSample =
          cloud.positions[1] - spacing * (Point::Constant(6) + random.point(-1, 1));
        const auto field = fieldOf(cloud);
        EXPECT_LT(checkAll(evaluate(*field, grid), samplesOf(grid), cloud.positions), rounding)
          << "cloud " << i << " at " << origin << ", spacing " << spacing;
      }
    }
  }
}

TEST(Distance, OnTheSourceItIsPlainZero)
{
  for (const Mesh& mesh : {cube(), icosphere(2)})
  {
    for (const double distance : evaluate(*fieldOf(mesh), mesh.points).distances)
    {
      // Corners other than a triangle's first are only as exact as the sides that lead to them.
      EXPECT_LT(std::abs(distance), 1e-15);
    }
  }
  const Grid grid = gridOver(Point(-0.5, -0.5, -0.5), Point(2.5, 2.5, 2.5), {3, 3, 3});
  const Distances found = evaluate(*fieldOf(cube()), grid);
  ASSERT_EQ(samplesOf(grid)[0], Point(0, 0, 0));
  EXPECT_EQ(found.distances[0], 0);
  EXPECT_FALSE(std::signbit(found.distances[0]));
  const Cloud cloud = sphereCloud(100);
  for (const double distance : evaluate(*fieldOf(cloud), cloud.positions).distances)
  {
    EXPECT_EQ(distance, 0);
    EXPECT_FALSE(std::signbit(distance));
  }
}

TEST(Distance, ScaleAndPlaceChangeNothing)
{
  const Mesh mesh = torus(30, 15);
  const std::vector<Point> samples = samplesOf(someGrids()[0]);
  for (const double scale : {1e-100, 1e-30, 1e30, 7e99}) // the torus reaches to 1.4
  {
    const Mesh scaled = mesh.scaled(scale);
    Grid grid = someGrids()[0];
    grid.firstSample *= scale;
    grid.spacing *= scale;
    EXPECT_LT(checkAll(evaluate(*fieldOf(scaled), grid), samplesOf(grid), scaled), rounding);
  }
  const Point far(1e6, -2e6, 3e6); // only the input is rounded there
  const Mesh moved = mesh.moved(far);
  Grid grid = someGrids()[0];
  grid.firstSample += far;
  EXPECT_LT(checkAll(evaluate(*fieldOf(moved), grid), samplesOf(grid), moved), rounding);
}

TEST(Distance, HasTheSameBitsInAnyExtentAndOnAnyThreads)
{
  SCOPED_TRACE("seeds 814, 815");
  for (const auto& field : {fieldOf(triangleSoup(500, 814)), fieldOf(randomCloud(500, 814))})
  {
    for (const Grid& grid :
      {someGrids()[0], someGrids()[1], gridOver(Point(-2, -2, -2), Point(2, 2, 2), {50, 45, 40})})
    {
      for (const double limit : {infinite, 0.2})
      {
        const Extent whole = grid.wholeExtent();
        const Distances expected = evaluate(*field, grid, whole, limit);
        EXPECT_EQ(
          evaluate(*field, grid, whole, limit, ShuffledThreads(815)).distances, expected.distances);
        for (const Extent& part : {Extent{3, 9, 1, 1, 0, 7}, Extent{0, 0, 0, 0, 0, 0},
               Extent{5, whole[1], 1, whole[3], 3, whole[5]}})
        {
          const Distances found = evaluate(*field, grid, part, limit);
          for (std::size_t n = 0; n < sampleCount(part); ++n)
          {
            ASSERT_EQ(
              found.distances[n], expected.distances[sampleNumber(whole, sampleIndex(part, n))]);
          }
        }
        EXPECT_TRUE(evaluate(*field, grid, {3, 2, 0, 1, 0, 1}, limit).distances.empty());
      }
    }
  }
}

TEST(Distance, BandIsTheFullRangeCutOff)
{
  SCOPED_TRACE("seed 816");
  for (const auto& field :
    {fieldOf(icosphere(3)), fieldOf(triangleSoup(300, 816)), fieldOf(sphereCloud(700))})
  {
    for (const Grid& grid : someGrids())
    {
      for (const double limit : {0.01, 0.3, 2.0})
      {
        const Distances full = evaluate(*field, grid);
        const Distances band = evaluate(*field, grid, grid.wholeExtent(), limit);
        const Distances scattered = evaluate(*field, samplesOf(grid), limit);
        for (std::size_t n = 0; n < full.distances.size(); ++n)
        {
          const double expected =
            std::copysign(std::min(std::abs(full.distances[n]), limit), full.distances[n]);
          ASSERT_NEAR(band.distances[n], expected, 1e-14 * limit);
          ASSERT_NEAR(std::abs(scattered.distances[n]), std::abs(expected), 1e-14 * limit);
          ASSERT_EQ(std::abs(full.distances[n]) > limit * (1 + 1e-12),
            std::abs(full.distances[n]) > limit * (1 + 1e-12) &&
              std::abs(band.distances[n]) == limit);
        }
      }
    }
  }
}

TEST(Distance, BandIsThatOfTheUnitOfLength)
{
  for (const double unit : {1e-6, 1e6})
  {
    const auto field = fieldOf(icosphere(2).scaled(unit));
    Grid grid = someGrids()[0];
    grid.firstSample *= unit;
    grid.spacing *= unit;
    const double limit = 0.3 * unit;
    const Distances full = evaluate(*field, grid);
    const Distances band = evaluate(*field, grid, grid.wholeExtent(), limit);
    const Distances scattered = evaluate(*field, samplesOf(grid), limit);
    for (std::size_t n = 0; n < full.distances.size(); ++n)
    {
      const double expected = std::min(std::abs(full.distances[n]), limit);
      ASSERT_NEAR(std::abs(band.distances[n]), expected, 1e-14 * unit) << n;
      ASSERT_NEAR(std::abs(scattered.distances[n]), expected, 1e-14 * unit) << n;
    }
  }
}

TEST(Distance, SignFollowsTheRuleWhateverElseIsWritten)
{
  const Mesh twice = icosphere(2).with(icosphere(2).mapped(
    [](const Point& p) { return Point(0.7 * p[0] + 0.2, 0.7 * p[1], 0.7 * p[2]); }));
  const auto field = fieldOf(twice);
  const Grid grid = someGrids()[0];
  const std::size_t count = sampleCount(grid.wholeExtent());
  for (const auto rule : {winding::InsideRule::signedThreshold,
         winding::InsideRule::absoluteThreshold, winding::InsideRule::odd})
  {
    for (const double threshold : {0.5, 1.5})
    {
      std::vector<float> values(count), ofValues(count), ofInside(count), ofNothing(count);
      std::vector<double> doubles(count);
      std::vector<unsigned char> inside(count);
      FieldOutput withValues, withInside, withNothing;
      for (FieldOutput* output : {&withValues, &withInside, &withNothing})
      {
        output->isInside = {rule, threshold};
      }
      withValues.values = values.data();
      withValues.distances = ofValues.data();
      withInside.inside = inside.data();
      withInside.distances = ofInside.data();
      withNothing.distances = ofNothing.data();
      for (const FieldOutput& output : {withValues, withInside, withNothing})
      {
        field->evaluate(grid, grid.wholeExtent(), output, serial);
      }
      EXPECT_EQ(ofValues, ofInside);
      EXPECT_EQ(ofValues, ofNothing);
      for (std::size_t n = 0; n < count; ++n)
      {
        ASSERT_EQ(ofInside[n] < 0, inside[n] == 1);
      }
      EXPECT_GT(std::count(inside.begin(), inside.end(), 1), 0);
    }
  }
}

TEST(Distance, FloatsNeitherVanishNorBecomeInfinite)
{
  std::vector<float> distances(2);
  std::vector<unsigned char> inside(2);
  FieldOutput output;
  output.distances = distances.data();
  output.inside = inside.data();
  for (const double scale : {1e-60, 1e60})
  {
    const Mesh mesh = icosphere(1).scaled(scale);
    const std::vector<Point> samples = {Point(0, 0, 0), Point(3 * scale, 0, 0)};
    fieldOf(mesh)->evaluate(winding::VectorsView(samples[0].data(), 2), output, serial);
    const float expected =
      scale < 1 ? std::numeric_limits<float>::min() : std::numeric_limits<float>::max();
    EXPECT_EQ(distances[0], -expected);
    EXPECT_EQ(distances[1], expected);
  }
}

TEST(Distance, NowhereIsNoDistanceAndNothingIsFarFromAll)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Point> samples = {
    Point(nan, 0, 0), Point(0, infinite, 0), Point(0, 0, -infinite), Point(1e300, 0, 0)};
  const Distances found = evaluate(*fieldOf(icosphere(1)), samples);
  for (std::size_t n = 0; n < 3; ++n)
  {
    EXPECT_TRUE(std::isnan(found.distances[n]));
    EXPECT_EQ(found.inside[n], 0);
  }
  EXPECT_GT(found.distances[3], 1e89) << "cut off where w has long been 0";

  const double most = std::numeric_limits<double>::max();
  for (const auto& field : {fieldOf(Mesh()), fieldOf(Cloud())})
  {
    const Grid grid = someGrids()[0];
    for (const double distance : evaluate(*field, grid).distances)
    {
      ASSERT_EQ(distance, most);
    }
    for (const double distance : evaluate(*field, grid, grid.wholeExtent(), 3).distances)
    {
      ASSERT_EQ(distance, 3);
    }
    EXPECT_EQ(evaluate(*field, std::vector<Point>{Point(0, 0, 0)}).distances[0], most);
  }
  EXPECT_TRUE(evaluate(*fieldOf(icosphere(1)), std::vector<Point>()).distances.empty());
}

TEST(Distance, UnusableTrianglesAreNotNear)
{
  Mesh mesh = icosphere(1);
  const auto bad = static_cast<std::int32_t>(mesh.points.size());
  mesh.points.emplace_back(5, 5, std::numeric_limits<double>::quiet_NaN());
  mesh.points.emplace_back(5, 5, 5);
  mesh.triangles.push_back({bad, bad + 1, 0});
  mesh.triangles.push_back({bad + 1, 9999, 0});
  mesh.triangles.push_back({bad + 1, bad + 1, bad + 1});
  const double distance = evaluate(*fieldOf(mesh), std::vector<Point>{Point(5, 5, 5)}).distances[0];
  EXPECT_NEAR(distance, naiveDistance(Point(5, 5, 5), icosphere(1)), 1e-14);
}
