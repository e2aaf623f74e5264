// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/Pi.h"
#include "farfield/TriangleFarField.h"
#include "support/FarFields.h"
#include "support/Interruption.h"
#include "support/Serial.h"

#include "base/FlushToZero.h"
#include "base/Views.h"
#include "source/Surface.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <limits>
#include <numeric>
#include <thread>

/**
 * Values of far fields do not depend on extents, threads or the order of work, and they are numbers
 * wherever there is one.
 */

namespace
{

using namespace shapes;
using winding::Extent;
using winding::FarField;
using winding::FarFieldAccuracy;
using winding::Grid;

std::vector<std::unique_ptr<FarSource>> someSources()
{
  std::vector<std::unique_ptr<FarSource>> sources;
  sources.push_back(farSource(icosphere(3).part(0, 900)));
  sources.push_back(farSource(randomCloud(3000, 321)));
  return sources;
}

} // namespace

TEST(FarFieldSamples, HaveTheSameBitsInAnyExtent)
{
  const Eigen::Vector3i dimensions(61, 37, 50);
  const std::vector<Extent> extents = {{0, 60, 0, 36, 0, 49}, {5, 5, 0, 36, 0, 49},
    {0, 60, 11, 11, 0, 49}, {0, 60, 0, 36, 31, 31}, {1, 58, 7, 30, 2, 45}, {30, 33, 30, 33, 30, 33},
    {60, 60, 36, 36, 49, 49}, {17, 17, 18, 18, 19, 19}};
  for (const auto& source : someSources())
  {
    const Grid grid = shapes::gridAround(source->bounds(), dimensions, 0.1);
    for (const double tolerance : {1e-2, 1e-4})
    {
      const FarField field = fieldOf(*source, tolerance);
      const std::vector<float> expected = valuesOn(field, grid);
      for (const Extent& extent : extents)
      {
        const std::vector<float> values = valuesOn(field, grid, extent, serial);
        std::size_t different = 0;
        for (std::size_t n = 0; n < values.size(); ++n)
        {
          different +=
            values[n] !=
            expected[winding::sampleNumber(grid.wholeExtent(), winding::sampleIndex(extent, n))];
        }
        EXPECT_EQ(different, 0u) << tolerance << ", " << extent[0] << " " << extent[1] << " "
                                 << extent[2] << " " << extent[3] << " " << extent[4] << " "
                                 << extent[5];
      }
    }
  }
}

TEST(FarFieldSamples, HaveTheSameBitsInSevenPieces)
{
  for (const auto& source : someSources())
  {
    const Grid grid = shapes::gridAround(source->bounds(), {40, 33, 47}, 0.1);
    const FarField field = fieldOf(*source);
    std::vector<float> joined;
    for (int piece = 0; piece < 7; ++piece)
    {
      const std::vector<float> values =
        valuesOn(field, grid, {0, 39, 0, 32, 47 * piece / 7, 47 * (piece + 1) / 7 - 1}, serial);
      joined.insert(joined.end(), values.begin(), values.end());
    }
    EXPECT_EQ(joined, valuesOn(field, grid));
  }
}

TEST(FarFieldSamples, HaveTheSameBitsOnAnyThreads)
{
  for (const auto& source : someSources())
  {
    const Grid grid = shapes::gridAround(source->bounds(), {40, 33, 47}, 0.1);
    const std::vector<Point> scattered = randomPoints(3000, -1.5, 1.5, 322);
    const FarField field = fieldOf(*source);
    ShuffledThreads threads(323);
    const FarField other(source->sources(), FarFieldAccuracy::of(1e-3), threads);
    EXPECT_EQ(valuesOn(other, grid, grid.wholeExtent(), threads), valuesOn(field, grid));
    EXPECT_EQ(valuesAt(other, scattered, threads), valuesAt(field, scattered));
  }
}

TEST(FarFieldSamples, DependOnOtherScatteredSamplesWithinTheToleranceOnly)
{
  SCOPED_TRACE("seeds 324, 325");
  for (const auto& source : someSources())
  {
    const std::vector<Point> samples = randomPoints(2000, -1.5, 1.5, 324);
    const FarField field = fieldOf(*source);
    const std::vector<float> expected = valuesAt(field, samples);
    // The order matters only among samples of one place on the curve, and there are none here.
    const std::vector<Point> backward(samples.rbegin(), samples.rend());
    const std::vector<float> reversed = valuesAt(field, backward);
    EXPECT_EQ(std::vector<float>(reversed.rbegin(), reversed.rend()), expected);
    // The number of samples matters, since it makes other cells.
    Random random(325);
    std::vector<Point> some;
    std::vector<float> expectedOfSome;
    for (std::size_t i = 0; i < 200; ++i)
    {
      const std::size_t chosen = random.bits() % samples.size();
      some.push_back(samples[chosen]);
      expectedOfSome.push_back(expected[chosen]);
    }
    const std::vector<float> values = valuesAt(field, some);
    for (std::size_t i = 0; i < some.size(); ++i)
    {
      EXPECT_NEAR(values[i], expectedOfSome[i], 2e-3); // twice the tolerance
    }
    EXPECT_LT(largestError(*source, some, values), 1e-3);      // measured: 7.8e-4
    EXPECT_LT(largestError(*source, samples, expected), 1e-3); // measured: 6.5e-4
  }
}

TEST(FarFieldSamples, MayBeEqualOrFew)
{
  SCOPED_TRACE("seed 326");
  for (const auto& source : someSources())
  {
    const FarField field = fieldOf(*source);
    EXPECT_TRUE(valuesAt(field, std::vector<Point>()).empty());
    for (const Point& q : randomPoints(20, -1.5, 1.5, 326))
    {
      const std::vector<Point> one(1, q), many(3000, q);
      EXPECT_LT(largestError(*source, one, valuesAt(field, one)), 1e-3); // measured: 4.5e-4
      const std::vector<float> values = valuesAt(field, many);
      EXPECT_EQ(values, std::vector<float>(many.size(), values[0]));
      EXPECT_LT(largestError(*source, one, {values[0]}), 1e-3); // measured: 4.5e-4
    }
  }
}

TEST(FarFieldSamples, AloneAreRightAnywhere)
{
  SCOPED_TRACE("seeds 327, 328");
  for (const auto& source : someSources())
  {
    std::vector<Point> samples = randomPoints(300, -1.5, 1.5, 327);
    Random random(328);
    for (const Point& place : source->places(300, 328))
    {
      samples.emplace_back(place + std::exp2(random(-20, -3)) * random.direction());
    }
    for (const double tolerance : {1e-2, 1e-3, 1e-6})
    {
      const FarField field = fieldOf(*source, tolerance);
      std::vector<float> values;
      for (const Point& q : samples)
      {
        const std::vector<float> value = valuesAt(field, {q});
        EXPECT_EQ(valuesAt(field, {q}), value);
        values.push_back(value[0]);
      }
      EXPECT_LT(largestError(*source, samples, values), tolerance); // measured: 0.41 of it
    }
  }
}

TEST(FarFieldSamples, FarAwayOrWithoutAPlaceDoNotSpoilTheOthers)
{
  SCOPED_TRACE("seed 327");
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const auto& source : someSources())
  {
    const FarField field = fieldOf(*source);
    std::vector<Point> samples = randomPoints(1000, -1.5, 1.5, 327);
    const std::vector<float> expected = valuesAt(field, samples);
    std::vector<Point> all = {{nan, 0, 0}, {0, infinity, 0}, {0, 0, -infinity}};
    const std::vector<Point> far = {{1e200, 0, 0}, {0, -1e308, 1e-3}, {1e6, 1e6, -1e6}, {180, 0, 0},
      {0, -1000, 0}, {0, 0, 170}, {1e30, -1e30, 1e30}, {-1e12, 0, 0}, {200, 100, 50}};
    all.insert(all.end(), far.begin(), far.end());
    all.insert(all.end(), samples.begin(), samples.end());
    const std::vector<float> values = valuesAt(field, all);
    EXPECT_TRUE(std::isnan(values[0]) && std::isnan(values[1]) && std::isnan(values[2]));
    EXPECT_EQ(std::vector<float>(values.begin() + 12, values.end()), expected);
    // All sources act as one dipole distribution there; measured: 2.9e-13.
    EXPECT_LT(largestError(*source, far, {values.begin() + 3, values.begin() + 12}), 1e-11);
  }
}

TEST(FarFieldSamples, AreFiniteOnTheSources)
{
  const Mesh mesh = icosphere(2).with(triangleSoup(50, 328));
  std::vector<Point> onMesh = mesh.points;
  for (const auto& t : mesh.triangles)
  {
    const Point &a = mesh.points[static_cast<std::size_t>(t[0])],
                &b = mesh.points[static_cast<std::size_t>(t[1])],
                &c = mesh.points[static_cast<std::size_t>(t[2])];
    onMesh.emplace_back((a + b) / 2);
    onMesh.emplace_back((a + b + c) / 3);
    onMesh.emplace_back(0.5 * a + 0.25 * b + 0.25 * c);
  }
  const Cloud cloud = randomCloud(2000, 329);
  for (const double tolerance : {1e-2, 1e-6})
  {
    for (const float value : valuesAt(fieldOf(*farSource(mesh), tolerance), onMesh))
    {
      ASSERT_TRUE(std::isfinite(value));
    }
    for (const float value : valuesAt(fieldOf(*farSource(cloud), tolerance), cloud.positions))
    {
      ASSERT_TRUE(std::isfinite(value));
    }
    // Vertices, edges and faces lie on samples of a grid, then all points of a cloud on one of
    // them.
    const auto cells = farSource(surfaceOf(randomCells(3, 330)));
    const Grid grid = gridOf({-0.5, -0.5, -0.5}, {0.25, 0.25, 0.25}, {17, 17, 17});
    for (const float value : valuesOn(fieldOf(*cells, tolerance), grid))
    {
      ASSERT_TRUE(std::isfinite(value));
    }
    Cloud heap;
    heap.positions.assign(3000, Point(0.25, 0.5, 0.75));
    heap.normals.assign(3000, Point(1, 0, 0));
    for (const float value : valuesOn(fieldOf(*farSource(heap), tolerance), grid))
    {
      ASSERT_TRUE(std::isfinite(value));
    }
  }
}

TEST(FarFieldSamples, AtVerticesAreThoseOfTheDirectSum)
{
  for (const Mesh& mesh : {torus(40, 20), icosphere(3).part(0, 900)})
  {
    const std::vector<double> expected = valuesOf(winding::TriangleSum(clean(mesh)), mesh.points);
    for (const double tolerance : {1e-2, 1e-6})
    {
      const std::vector<float> values = valuesAt(fieldOf(*farSource(mesh), tolerance), mesh.points);
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        ASSERT_NEAR(values[i], expected[i], tolerance) << mesh.points[i].transpose();
      }
    }
  }
}

TEST(FarFieldSamples, AreFiniteOnGridsOfAnySize)
{
  for (const auto& source : someSources())
  {
    for (const double tolerance : {1e-2, 1e-6})
    {
      const FarField field = fieldOf(*source, tolerance);
      for (const double spacing :
        {1e-300, 1e-100, 1e-30, 1e-12, 1e3, 1e5, 1e8, 1e12, 1e13, 1e30, 1e38, 1e60, 1e100})
      {
        const Point step = Point::Constant(spacing);
        for (const float value :
          valuesOn(field, gridOf(Point(0.1, 0.2, 0.3) - 5 * step, step, {11, 12, 13})))
        {
          ASSERT_TRUE(std::isfinite(value)) << spacing << ", " << tolerance;
        }
      }
      for (const double away : {1e3, 1e12, 1e30, 1e60, 1e200})
      {
        // The limit is what all areas in one place would give; offsets beyond 1e12 are cut off.
        const Grid grid = gridOf({away, 0, -away}, Point::Constant(away / 10), {11, 12, 13});
        for (const float value : valuesOn(field, grid))
        {
          ASSERT_LE(std::abs(value), std::max(1 / (away * away), 1e-20))
            << away << ", " << tolerance;
        }
      }
    }
  }
}

TEST(FarFieldSamples, OfAnEmptyExtentAreNone)
{
  const FarField field = fieldOf(*farSource(icosphere(2)));
  const Grid grid = gridOf({-1, -1, -1}, {0.2, 0.2, 0.2}, {11, 11, 11});
  EXPECT_TRUE(valuesOn(field, grid, {0, 10, 5, 4, 0, 10}, serial).empty());
}

TEST(FarFieldSamples, AreLeftUndoneByAnInterruptedExecutor)
{
  const FarField field = fieldOf(*farSource(icosphere(3)));
  const Grid grid = gridOf({-1.5, -1.5, -1.5}, Point::Constant(0.06), {50, 50, 50});
  const std::vector<Point> samples = randomPoints(5000, -1.5, 1.5, 331);
  std::vector<float> values(125000);
  winding::FieldOutput output;
  output.values = values.data();
  for (const std::size_t blocks : {0, 1, 3})
  {
    Interruption onGrid(0, blocks), atSamples(0, blocks);
    EXPECT_THROW(field.evaluate(grid, grid.wholeExtent(), output, onGrid), winding::Interrupted);
    EXPECT_THROW(
      field.evaluate(winding::VectorsView(samples[0].data(), samples.size()), output, atSamples),
      winding::Interrupted);
  }
}

#ifdef WINDING_HAS_MXCSR
TEST(FarFieldSamples, LeaveTheModeOfTheProcessorAsItWas)
{
  const auto source = farSource(icosphere(2));
  const Grid grid = gridOf({-1.5, -1.5, -1.5}, Point::Constant(0.3), {11, 11, 11});
  const std::vector<Point> samples = randomPoints(100, -1.5, 1.5, 332);
  // The flags of exceptions that happened (inexact and others) may change, the modes may not.
  constexpr unsigned modes = ~0x3fu;
  const unsigned before = _mm_getcsr();
  const unsigned full = before & ~0x8040u;
  for (const unsigned mode : {full, full | 0x8000, full | 0x0040})
  {
    _mm_setcsr(mode);
    const FarField field = fieldOf(*source);
    valuesOn(field, grid);
    valuesAt(field, samples);
    gradientsAt(field, samples);
    const unsigned after = _mm_getcsr();
    _mm_setcsr(before);
    EXPECT_EQ(after & modes, mode & modes);
  }
}
#endif

TEST(FarFieldSamples, MayAllBeInOnePlaceWhereTrianglesMeet)
{
  // All samples lie on the common vertex of a fan: their distances say nothing about how large a
  // triangle may be. The test took minutes when the fan was cut without end.
  Mesh fan;
  fan.points.push_back({0, 0, 1});
  for (int i = 0; i < 2000; ++i)
  {
    const double angle = i * 2 * winding::pi / 2000;
    fan.points.push_back({std::cos(angle), std::sin(angle), 0});
    fan.triangles.push_back({0, 1 + i, 1 + (i + 1) % 2000});
  }
  const winding::Surface surface = clean(fan);
  const winding::TriangleFarField farField(
    surface.vertices, surface.triangles, surface.bounds, FarFieldAccuracy::of(1e-3));
  for (const std::size_t count : {1, 5000})
  {
    const std::vector<Point> samples(count, Point(0, 0, 1));
    std::vector<double> values(count, std::nan(""));
    winding::FieldOutput output;
    output.doubleValues = values.data();
    const winding::VectorsView view(samples[0].data(), count);
    farField.suiting(view, serial)->evaluate(view, output, serial);
    EXPECT_TRUE(std::isfinite(values[0]));
  }
}

TEST(FarFieldSamples, AloneLeaveTrianglesAsTheyAre)
{
  // Several samples in one place ask for cut triangles, a single one does not.
  const Mesh sphere = icosphere(2);
  const winding::Surface surface = clean(sphere);
  const winding::TriangleFarField farField(
    surface.vertices, surface.triangles, surface.bounds, FarFieldAccuracy::of(1e-3));
  const std::vector<Point> samples(2, Point(0.1, 0.2, 0.3));
  const winding::VectorsView one(samples[0].data(), 1), other(samples[1].data(), 1),
    both(samples[0].data(), 2);
  Interruption interruption(0);
  EXPECT_THROW(farField.suiting(one, interruption), winding::Interrupted);
  const auto whole = farField.suiting(one, serial);
  const auto cut = farField.suiting(both, serial);
  ASSERT_NE(whole, nullptr);
  EXPECT_NE(cut, whole);
  EXPECT_EQ(farField.suiting(other, interruption), whole) << "is there already";
  EXPECT_EQ(farField.suiting(both, serial), cut) << "is still there";
}

TEST(FarFieldSamples, OfOtherDistancesGetTrianglesCutAnew)
{
  const Mesh sphere = icosphere(2);
  const winding::Surface surface = clean(sphere);
  const winding::TriangleFarField farField(
    surface.vertices, surface.triangles, surface.bounds, FarFieldAccuracy::of(1e-3));
  const auto gridOf = [](int voxels)
  {
    Grid grid;
    grid.dimensions.setConstant(voxels);
    grid.spacing.setConstant(2.2 / voxels);
    grid.firstSample.setConstant(-1.1 + 1.1 / voxels);
    return grid;
  };
  const auto coarse = farField.suiting(gridOf(100), serial);
  const auto fine = farField.suiting(gridOf(200), serial);
  EXPECT_NE(fine, coarse);
  EXPECT_EQ(farField.suiting(gridOf(200), serial), fine) << "is kept";
  EXPECT_NE(farField.suiting(gridOf(100), serial), fine);
}

TEST(FarFieldSamples, AloneGetATreeThatOneThreadBuildsWhileTheOthersWait)
{
  /// Calls beside() in the middle of the first run, and counts runs.
  class Watching final : public winding::Executor
  {
  public:
    void run(std::size_t count, const std::function<void(std::size_t)>& work) override
    {
      if (runs++ == 0 && beside)
      {
        beside();
      }
      winding::SerialExecutor().run(count, work);
    }
    std::function<void()> beside;
    std::atomic<int> runs{0};
  };
  const Mesh sphere = icosphere(2);
  const winding::Surface surface = clean(sphere);
  const winding::TriangleFarField farField(
    surface.vertices, surface.triangles, surface.bounds, FarFieldAccuracy::of(1e-3));
  const Point sample(0.1, 0.2, 0.3);
  const winding::VectorsView one(sample.data(), 1);
  Watching first, second;
  std::shared_ptr<const winding::FarField> ofSecond;
  std::thread thread;
  first.beside = [&]
  {
    thread = std::thread([&] { ofSecond = farField.suiting(one, second); });
    // The other thread would come as far as to run something in much less time, if it could.
    const auto enough = std::chrono::steady_clock::now() + std::chrono::milliseconds(200);
    while (second.runs == 0 && std::chrono::steady_clock::now() < enough)
    {
      std::this_thread::yield();
    }
  };
  const auto ofFirst = farField.suiting(one, first);
  thread.join();
  EXPECT_GT(first.runs, 0);
  EXPECT_EQ(second.runs, 0);
  EXPECT_EQ(ofSecond, ofFirst);
}
