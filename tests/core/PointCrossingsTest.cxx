#include "PointCrossings.h"

#include "DirectSum.h"
#include "Interruption.h"
#include "LatticeSolids.h"
#include "Shapes.h"
#include "ShuffledThreads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

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
  EXPECT_TRUE(winding::PointCrossings(surface).evaluate(
    winding::VectorsView(first, samples.size()), output, executor));
  return values;
}

std::vector<double> crossings(const Mesh& mesh, const std::vector<Point>& samples)
{
  winding::SerialExecutor serial;
  return crossings(clean(mesh), samples, serial);
}

/// Against the direct sum, which is no integer on the surface and within rounding of it.
void expectTheIntegers(const Mesh& mesh, const std::vector<Point>& samples)
{
  const winding::Surface surface = clean(mesh);
  winding::SerialExecutor serial;
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
  for (const Mesh& mesh : {tetrahedron(), cube(), icosphere(4), torus(48, 24), overlapping,
         icosphere(2).reversed().with(torus(24, 12)), icosphere(1).with(icosphere(1)),
         torus(7, 5).mapped(
           [](const Point& p) -> Point {
             return {1e3 * p[0], p[1], 1e-3 * p[2]};
           })})
  {
    const winding::Bounds bounds = clean(mesh).bounds;
    std::vector<Point> samples = randomPoints(5000, -0.1, 1.1, 262);
    for (Point& p : samples)
    {
      p = bounds.min() + p.cwiseProduct(bounds.sizes());
    }
    expectTheIntegers(mesh, samples);
    expectTheIntegers(mesh, pointsNear(mesh, 1000, 1e-6 * bounds.sizes().minCoeff(), 263));
  }
}

TEST(PointCrossings, OfUnevenSamplesAndTriangles)
{
  SCOPED_TRACE("seeds 264 …");
  // A speck inside a box of twelve large triangles, and most samples at the speck.
  const Point place(0.31, 0.62, 0.43);
  const Mesh mesh = cube().with(scaled(icosphere(4), 1e-5, place));
  std::vector<Point> samples = randomPoints(200, -0.2, 1.2, 264);
  for (const Point& p : randomPoints(6000, -1.5, 1.5, 265))
  {
    samples.push_back(place + 1e-5 * p);
  }
  // Along x, along y, along a diagonal, and all in one place.
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
    // Each of these alone, so that there is nothing else that columns could be made of.
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
  winding::SerialExecutor serial;
  for (std::size_t i = 0; i < samples.size(); i += 97)
  {
    EXPECT_EQ(crossings(surface, {samples[i]}, serial)[0], expected[i]);
  }
  // A million sizes away the coordinates are rounded, the same for the mesh and for the samples.
  const Point far(1e6, -1e6, 1e6);
  std::vector<Point> there = samples;
  for (Point& p : there)
  {
    p += far;
  }
  expectTheIntegers(scaled(mesh, 1, far), there);
}

TEST(PointCrossings, OfSamplesThatAreNowhereOrFarAway)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
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

TEST(PointCrossings, StopWhenInterrupted)
{
  const winding::Surface surface = clean(icosphere(3));
  const std::vector<Point> samples = randomPoints(1000, -1, 1, 267);
  std::vector<double> values(samples.size());
  winding::FieldOutput output;
  output.doubleValues = values.data();
  int calls = 0;
  for (bool complete = false; !complete; ++calls)
  {
    Interruption executor(calls);
    complete = winding::PointCrossings(surface).evaluate(
      winding::VectorsView(samples[0].data(), samples.size()), output, executor);
  }
  EXPECT_GT(calls, 2) << "there was something to interrupt";
}
