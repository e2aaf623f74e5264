// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/PointCrossings.h"

#include "base/Bounds.h"
#include "base/Executor.h"
#include "base/Views.h"
#include "rays/RowCrossings.h"
#include "source/Grid.h"
#include "source/Surface.h"
#include "sums/DirectSum.h"
#include "support/Interruption.h"
#include "support/LatticeSolids.h"
#include "support/RowValues.h"
#include "support/Serial.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace
{

using namespace shapes;

std::vector<double> crossings(
  const winding::Surface& surface, const std::vector<Point>& samples, winding::Executor& executor)
{
  std::vector<double> values(samples.size(), -7);
  winding::FieldOutput output;
  output.doubleValues = values.data();
  const double* first = samples.empty() ? nullptr : samples[0].data();
  winding::PointCrossings(surface).evaluate(
    winding::VectorsView(first, samples.size()), output, executor);
  return values;
}

std::vector<double> crossings(const Mesh& mesh, const std::vector<Point>& samples)
{
  return crossings(clean(mesh), samples, serial);
}

/// Asks the same crossings for one group of up to `most` samples after the other, and expects the
/// values that all samples have at once.
void expectTheSameAskedAgain(
  const winding::Surface& surface, const std::vector<Point>& samples, std::size_t most)
{
  const std::vector<double> expected = crossings(surface, samples, serial);
  const winding::PointCrossings kept(surface);
  ShuffledThreads threads(272);
  for (std::size_t first = 0, count = 1; first < samples.size();
       first += count, count = 3 * count % most + 1)
  {
    count = std::min(count, samples.size() - first);
    std::vector<double> values(count);
    winding::FieldOutput output;
    output.doubleValues = values.data();
    kept.evaluate(winding::VectorsView(samples[first].data(), count), output, threads);
    for (std::size_t i = 0; i < count; ++i)
    {
      const double wanted = expected[first + i];
      ASSERT_TRUE(values[i] == wanted || (std::isnan(wanted) && std::isnan(values[i])))
        << samples[first + i].transpose();
    }
  }
}

/// Compares crossings with the direct sum, which is no integer on the surface and within rounding
/// of it.
void expectTheIntegers(const Mesh& mesh, const std::vector<Point>& samples)
{
  const winding::Surface surface = clean(mesh);
  const std::vector<double> values = crossings(surface, samples, serial);
  const std::vector<double> expected = valuesOf(winding::TriangleSum(surface), samples);
  std::size_t compared = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    EXPECT_EQ(values[i], std::round(values[i]));
    if (std::abs(expected[i] - std::round(expected[i])) < 1e-7)
    {
      ++compared;
      ASSERT_EQ(values[i], std::round(expected[i])) << samples[i].transpose();
    }
  }
  EXPECT_GT(compared, samples.size() * 9 / 10);
}

Mesh scaled(const Mesh& mesh, double factor, const Point& shift = Point::Zero())
{
  return mesh.mapped([&](const Point& p) -> Point { return factor * p + shift; });
}

/// Tetrahedra through each other. The first corner of each is anywhere, and the others are within a
/// box around it or, for needles, one of them is anywhere and two are near the first.
Mesh tetrahedra(int count, double size, bool areNeedles, unsigned seed)
{
  Random random(seed);
  Mesh mesh;
  for (int i = 0; i < count; ++i)
  {
    Mesh next = tetrahedron();
    next.points[0] = random.point(-1, 1);
    for (std::size_t corner = 1; corner < 4; ++corner)
    {
      next.points[corner] = areNeedles && corner == 1
                              ? random.point(-1, 1)
                              : Point(next.points[0] + random.point(-size, size));
    }
    mesh = i == 0 ? next : mesh.with(next);
  }
  return mesh;
}

/// A cylinder whose axis is along no coordinate, and whose sides are slivers.
Mesh tiltedCylinder(int sides)
{
  const Point axis = Point(1, 0.8, 0.7).normalized();
  const Point u = axis.cross(Point(0, 0, 1)).normalized(), v = axis.cross(u);
  Mesh mesh;
  for (int i = 0; i < sides; ++i)
  {
    const double angle = 2 * std::acos(-1.0) * i / sides;
    const Point across = 0.3 * (std::cos(angle) * u + std::sin(angle) * v);
    mesh.points.push_back(across - 0.9 * axis);
    mesh.points.push_back(across + 0.9 * axis);
    const int a = 2 * i, b = 2 * ((i + 1) % sides), centre = 2 * sides;
    mesh.triangles.push_back({a, b, a + 1});
    mesh.triangles.push_back({b, b + 1, a + 1});
    mesh.triangles.push_back({a, centre, b});
    mesh.triangles.push_back({a + 1, b + 1, centre + 1});
  }
  mesh.points.push_back(-0.9 * axis);
  mesh.points.push_back(0.9 * axis);
  return mesh;
}

/// Samples of which all but two are in a place so small that a single column holds them.
std::vector<Point> cluster(std::size_t count, unsigned seed)
{
  std::vector<Point> samples = randomPoints(count, -1e-6, 1e-6, seed);
  for (Point& p : samples)
  {
    p += Point(0.1, 0.2, 0.3);
  }
  samples.emplace_back(-0.9, -0.9, -0.9);
  samples.emplace_back(0.9, 0.9, 0.9);
  return samples;
}

/// Compares crossings with the direct sum, and crossings from several threads with those from one.
void expectTheIntegersFromThreads(const Mesh& mesh, const std::vector<Point>& samples)
{
  expectTheIntegers(mesh, samples);
  ShuffledThreads threads(268);
  EXPECT_EQ(crossings(clean(mesh), samples, threads), crossings(mesh, samples));
}

/// An executor that writes down the shares that are set, and the number of blocks that it runs.
class ShareLog final : public winding::Executor
{
public:
  void run(std::size_t count, const std::function<void(std::size_t)>& work) override
  {
    blocks += count;
    sharesOfRuns.push_back(shares.back());
    winding::SerialExecutor().run(count, work);
  }
  void runBriefly(std::size_t count, const std::function<void(std::size_t)>& work) override
  {
    winding::SerialExecutor().run(count, work);
  }
  void setShare(double first, double last) override { shares.emplace_back(first, last); }
  std::pair<double, double> share() const override { return shares.back(); }

  std::vector<std::pair<double, double>> shares = {{0.25, 0.75}}, sharesOfRuns;
  std::size_t blocks = 0;
};

} // namespace

TEST(PointCrossings, AreTheWindingNumbersOfLatticeSolidsWhateverTheRaysHit)
{
  SCOPED_TRACE("seed 261");
  for (const LatticeSolid& solid : latticeSolids(261))
  {
    const std::vector<double> values = crossings(solid.mesh, solid.samples);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      ASSERT_TRUE(
        solid.isOff(i) ? values[i] == solid.windings[i] : values[i] == 0 || values[i] == 1)
        << solid.samples[i].transpose() << ": " << values[i];
    }
  }
}

TEST(PointCrossings, AgreeWithTheDirectSum)
{
  SCOPED_TRACE("seeds 262, 263");
  const Mesh overlapping = icosphere(3).with(scaled(icosphere(2), 0.7, Point(0.6, 0, 0)));
  const auto stretched = [](const Point& p) -> Point
  {
    return {1e3 * p[0], p[1], 1e-3 * p[2]};
  };
  for (const Mesh& mesh : {tetrahedron(), cube(), icosphere(4), torus(48, 24), overlapping,
         icosphere(2).reversed().with(torus(24, 12)), icosphere(1).with(icosphere(1)),
         torus(7, 5).mapped(stretched)})
  {
    const winding::Bounds bounds = clean(mesh).bounds;
    expectTheIntegers(mesh, randomPointsAround(bounds, 5000, -0.1, 1.1, 262));
    expectTheIntegers(mesh, pointsNear(mesh, 1000, 1e-6 * bounds.sizes().minCoeff(), 263));
  }
}

TEST(PointCrossings, OfUnevenSamplesAndTriangles)
{
  SCOPED_TRACE("seeds 264 …");
  // The mesh is a speck inside a box of twelve large triangles, and most samples are at the speck.
  const Point place(0.31, 0.62, 0.43);
  const Mesh mesh = cube().with(scaled(icosphere(4), 1e-5, place));
  std::vector<Point> samples = randomPoints(200, -0.2, 1.2, 264);
  for (const Point& p : randomPoints(6000, -1.5, 1.5, 265))
  {
    samples.push_back(place + 1e-5 * p);
  }
  // Further samples are along x, along y, along a diagonal, and all in one place.
  for (int i = 0; i < 1500; ++i)
  {
    const double t = -0.1 + 1.2 * i / 1500;
    samples.emplace_back(t, place[1], place[2]);
    samples.emplace_back(place[0], t, place[2]);
    samples.emplace_back(t, t, t);
    samples.push_back(place);
  }
  expectTheIntegers(mesh, samples);
  for (std::size_t i = 0; i < 4; ++i)
  {
    // Each of these four sets comes alone, too, so that columns can be made of nothing else.
    std::vector<Point> alike;
    for (std::size_t n = samples.size() - 6000 + i; n < samples.size(); n += 4)
    {
      alike.push_back(samples[n]);
    }
    expectTheIntegers(mesh, alike);
  }
}

TEST(PointCrossings, DoNotDependOnUnitOriginOtherSamplesOrThreads)
{
  SCOPED_TRACE("seed 266");
  const Mesh mesh = torus(96, 48);
  const std::vector<Point> samples = randomPoints(20'000, -1.5, 1.5, 266);
  const std::vector<double> expected = crossings(mesh, samples);
  EXPECT_GT(std::count(expected.begin(), expected.end(), 1), 1000);
  for (const double factor : {0x1p-330, 0x1p330})
  {
    std::vector<Point> there = samples;
    for (Point& p : there)
    {
      p *= factor;
    }
    EXPECT_EQ(crossings(scaled(mesh, factor), there), expected) << factor;
  }
  const winding::Surface surface = clean(mesh);
  ShuffledThreads threads(266);
  EXPECT_EQ(crossings(surface, samples, threads), expected);
  for (std::size_t i = 0; i < samples.size(); i += 97)
  {
    EXPECT_EQ(crossings(surface, {samples[i]}, serial)[0], expected[i]);
  }
  // Coordinates a million sizes away are rounded, but in the same way for the mesh and the samples.
  const Point far(1e6, -1e6, 1e6);
  std::vector<Point> there = samples;
  for (Point& p : there)
  {
    p += far;
  }
  expectTheIntegers(scaled(mesh, 1, far), there);
}

TEST(PointCrossings, OfFewSamplesAskedAgainAndAgain)
{
  SCOPED_TRACE("seeds 269, 270");
  const auto needle = [](const Point& p) -> Point
  {
    return {p[0], p[1], 1e-4 * p[2]};
  };
  const Mesh ball = icosphere(5);
  for (const Mesh& mesh : {ball, ball.with(ball.reversed().mapped(needle)).with(cube()),
         torus(96, 48).with(scaled(torus(96, 48), 1, Point(0.3, 0.2, 0.1)))})
  {
    const winding::Surface surface = clean(mesh);
    std::vector<Point> samples = randomPointsAround(surface.bounds, 2000, -0.1, 1.1, 269);
    const std::vector<Point> near = pointsNear(mesh, 500, 1e-9, 270);
    samples.insert(samples.end(), near.begin(), near.end());
    samples.insert(samples.end(), mesh.points.begin(), mesh.points.begin() + 500);
    samples.emplace_back(std::nan(""), 0, 0);
    expectTheSameAskedAgain(surface, samples, 7);
    expectTheSameAskedAgain(surface, samples, 1500);
  }
}

/// All samples, and nearly all triangles, are in one of the columns that are kept.
TEST(PointCrossings, OfCrowdedSamplesAskedAgain)
{
  SCOPED_TRACE("seed 271");
  const Mesh mesh = scaled(cube(), 100).with(icosphere(6));
  const std::vector<Point> samples = randomPoints(20000, -1, 1, 271);
  expectTheSameAskedAgain(clean(mesh), samples, samples.size());
}

TEST(PointCrossings, OfSamplesThatAreNowhereOrFarAway)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Point> samples = {{nan, 0, 0}, {0, nan, 0}, {0, 0, nan}, {infinity, 0, 0},
    {-infinity, 0, 0}, {0, infinity, 0}, {0, 0, -infinity}, {1e300, 0.1, 0.1}, {-1e300, 0.1, 0.1},
    {0.1, 1e308, 0.1}, {0.1, 0.1, 0.1}};
  const std::vector<double> values = crossings(icosphere(2), samples);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    if (samples[i].allFinite())
    {
      EXPECT_EQ(values[i], i + 1 == samples.size()) << i;
    }
    else
    {
      EXPECT_TRUE(std::isnan(values[i])) << i;
    }
  }
  EXPECT_TRUE(crossings(icosphere(2), {}).empty());
  EXPECT_EQ(crossings(Mesh(), {Point(0, 0, 0)}), std::vector<double>{0});
}

TEST(PointCrossings, OfNeedlesAndSlivers)
{
  SCOPED_TRACE("seeds 268 … 272");
  for (const Mesh& mesh : {tetrahedra(300, 1e-3, true, 269), tiltedCylinder(1500)})
  {
    expectTheIntegersFromThreads(mesh, randomPoints(4000, -1, 1, 270));
    expectTheIntegersFromThreads(mesh, cluster(4000, 271));
    expectTheIntegersFromThreads(mesh, pointsNear(mesh, 2000, 1e-6, 272));
  }
  // These needles are thinner than the roundings of their places.
  expectTheIntegers(tetrahedra(200, 1e-15, true, 273), randomPoints(2000, -1, 1, 270));
}

TEST(PointCrossings, OfSamplesOnLinesThroughOverlappingTriangles)
{
  SCOPED_TRACE("seeds 268, 274, 275");
  const Mesh mesh = tetrahedra(150, 1, false, 274);
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<Point> line, plane, grid, nearLine;
    Random random(275);
    for (int i = 0; i < 10'000; ++i)
    {
      Point p(0.1, 0.2, 0.3);
      p[axis] = -1.1 + 2.2 * i / 10'000;
      line.push_back(p);
      p[(axis + 1) % 3] *= 1 + 0x1p-52 * static_cast<double>(random.bits() % 4);
      nearLine.push_back(p);
      Point q = random.point(-1, 1);
      q[axis] = 0.1;
      plane.push_back(q);
      q[(axis + 1) % 3] = -1 + 0.02 * (i % 100);
      q[(axis + 2) % 3] = -1 + 0.02 * (i / 100);
      grid.push_back(q);
    }
    for (const std::vector<Point>& samples : {line, nearLine, plane, grid})
    {
      expectTheIntegersFromThreads(mesh, samples);
    }
  }
}

TEST(PointCrossings, OnTheChainAreThoseOfRows)
{
  SCOPED_TRACE("seed 277");
  const winding::Surface surface = clean(surfaceOf(randomCells(4, 277)));
  winding::Grid grid;
  grid.dimensions.setConstant(11);
  grid.spacing.setConstant(0.5);
  grid.firstSample.setConstant(-0.5);
  std::vector<Point> samples;
  for (std::size_t n = 0; n < winding::sampleCount(grid.wholeExtent()); ++n)
  {
    samples.push_back(grid.sample(n));
  }
  const std::vector<double> values = crossings(surface, samples, serial);
  const winding::RowCrossings rows(surface.vertices, surface);
  const std::vector<int> expected = rowValues(rows, grid, grid.wholeExtent(), 65536, serial);
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    EXPECT_EQ(values[n], expected[n]) << samples[n].transpose();
  }
}

TEST(PointCrossings, OfRaysAlongFacesFromSortedStarts)
{
  // The lines have many starts each, in the planes of faces and on edges; values are known off the
  // surface.
  SCOPED_TRACE("seed 276");
  const Cells cells = randomCells(4, 276);
  const Mesh mesh = surfaceOf(cells);
  for (const double y : {1.0, 1.5, 2.0})
  {
    std::vector<Point> samples;
    for (int i = 0; i < 1000; ++i)
    {
      samples.emplace_back(-1 + i * 0x1p-8 * 1.5, y, 2);
    }
    const std::vector<double> values = crossings(mesh, samples);
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      const double expected = windingOf(cells, samples[i]);
      ASSERT_TRUE(
        expected == 0 || expected == 1 ? values[i] == expected : values[i] == 0 || values[i] == 1)
        << samples[i].transpose();
    }
  }
}

TEST(PointCrossings, DivideWhatThereIsMuchOf)
{
  SCOPED_TRACE("seeds 277, 278");
  const Mesh mesh = tetrahedra(1000, 2, false, 277);
  const std::vector<Point> samples = cluster(8000, 278);
  expectTheIntegersFromThreads(mesh, samples);

  const winding::Surface surface = clean(mesh);
  ShareLog log;
  crossings(surface, samples, log);
  ASSERT_GT(log.sharesOfRuns.size(), 3);
  EXPECT_GT(log.blocks, log.sharesOfRuns.size() + 1) << "20 in 11 runs; undivided, 11 in 10";
  EXPECT_EQ(log.shares.front(), log.shares.back()) << "as it was";
  double last = 0.25;
  for (const auto& [begin, end] : log.sharesOfRuns)
  {
    EXPECT_GE(begin, last - 1e-12) << "progress never goes back";
    EXPECT_GE(end, begin);
    last = begin;
  }
  EXPECT_NEAR(log.sharesOfRuns.back().second, 0.75, 1e-12);
}

TEST(PointCrossings, WeighMoreWhereTrianglesOverlapAndForNeedles)
{
  SCOPED_TRACE("seeds 279, 280");
  const auto weight = [](const Mesh& mesh)
  {
    const winding::Surface surface = clean(mesh);
    return winding::PointCrossings(surface).weight(100'000);
  };
  const Mesh sphere = icosphere(3); // 1280 triangles
  EXPECT_GT(weight(tetrahedra(320, 1, false, 279)), 2 * weight(sphere));
  EXPECT_GT(weight(tetrahedra(320, 1e-3, true, 280)), 1.2 * weight(sphere));
  // The weight does not depend on the unit, and is less if there is no area across the rays at all.
  const auto flattened = [](const Point& p) -> Point
  {
    return {p[0], p[1], 0};
  };
  EXPECT_EQ(weight(scaled(sphere, 0x1p-300)), weight(sphere));
  EXPECT_LT(weight(Mesh()), weight(sphere));
  EXPECT_LT(weight(sphere.mapped(flattened)), weight(sphere));
}

TEST(PointCrossings, StopWhenInterrupted)
{
  SCOPED_TRACE("seeds 267, 277, 278");
  const std::pair<Mesh, std::vector<Point>> cases[] = {
    {icosphere(3), randomPoints(1000, -1, 1, 267)},
    {tetrahedra(600, 2, false, 277), cluster(6000, 278)}};
  int callsOfCase[2] = {0, 0};
  for (int i = 0; i < 2; ++i)
  {
    const winding::Surface surface = clean(cases[i].first);
    const std::vector<Point>& samples = cases[i].second;
    std::vector<double> values(samples.size());
    winding::FieldOutput output;
    output.doubleValues = values.data();
    for (bool complete = false; !complete; ++callsOfCase[i])
    {
      Interruption executor(callsOfCase[i], 1);
      const winding::VectorsView view(samples[0].data(), samples.size());
      complete =
        isCompleted([&] { winding::PointCrossings(surface).evaluate(view, output, executor); });
      EXPECT_NE(complete, executor.cameToPass());
    }
  }
  EXPECT_GT(callsOfCase[0], 2) << "there was something to interrupt";
  EXPECT_GT(callsOfCase[1], callsOfCase[0] + 4) << "and so were the columns in a column";
}
