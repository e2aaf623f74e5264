// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "field/InputPlaces.h"

#include "support/NaiveDistance.h"
#include "support/Samples.h"
#include "support/Serial.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

/**
 * Places of inputs that are nearest to samples, compared with distances from all triangles in long
 * double.
 */
namespace
{

using namespace shapes;
using winding::InputPlace;
using winding::InputPlaces;
using winding::TrianglesView;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

std::vector<InputPlace> placesOf(const InputPlaces& input, const std::vector<Point>& samples)
{
  std::vector<InputPlace> places(samples.size());
  input.find(
    samples.size(), [&](std::size_t n) { return samples[n]; }, places.data(), serial);
  return places;
}

std::vector<InputPlace> placesOf(
  const std::vector<TrianglesView>& views, const std::vector<Point>& samples)
{
  return placesOf(InputPlaces(views, "", serial), samples);
}

double distanceOf(const Point& p, const Mesh& mesh, std::size_t triangle)
{
  const auto& t = mesh.triangles[triangle];
  return naiveDistance(p, mesh.points[static_cast<std::size_t>(t[0])],
    mesh.points[static_cast<std::size_t>(t[1])], mesh.points[static_cast<std::size_t>(t[2])]);
}

/// Returns the point of a mesh at a place of its triangle.
Point pointAt(const Mesh& mesh, const InputPlace& place)
{
  Point point = Point::Zero();
  for (std::size_t n = 0; n < 3; ++n)
  {
    const auto id = static_cast<std::size_t>(mesh.triangles[place.primitive][n]);
    point += place.weights[n] * mesh.points[id];
  }
  return point;
}

/// Samples near a mesh, far from it, on its vertices and on the middles of its edges.
std::vector<Point> samplesFor(const Mesh& mesh, Random& random)
{
  std::vector<Point> samples;
  for (int n = 0; n < 150; ++n)
  {
    const auto& t = mesh.triangles[random.bits() % mesh.triangles.size()];
    const Point a = mesh.points[static_cast<std::size_t>(t[0])],
                b = mesh.points[static_cast<std::size_t>(t[1])];
    samples.push_back(random.point(-2, 2));
    samples.push_back(a);
    samples.push_back((a + b) / 2);
    samples.push_back(a + std::pow(10, random(-6, 0)) * random.direction());
  }
  return samples;
}

/// Compares the places of samples with the distances of all triangles. Returns the most by which a
/// place was farther than the nearest one, as a share of the size of the mesh and the distance.
double worstOf(
  const Mesh& mesh, const std::vector<Point>& samples, const std::vector<InputPlace>& places)
{
  const winding::Surface surface = clean(mesh);
  const double size = surface.bounds.sizes().norm();
  double worst = 0;
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    const InputPlace& place = places[n];
    const double nearest = naiveDistance(samples[n], mesh), unit = nearest + size;
    EXPECT_TRUE(place.exists());
    const double ofTriangle = distanceOf(samples[n], mesh, place.primitive);
    const double ofPoint = (samples[n] - pointAt(mesh, place)).norm();
    worst = std::max({worst, (ofTriangle - nearest) / unit, std::abs(ofPoint - nearest) / unit});
    for (std::size_t before = 0; before < place.primitive; ++before)
    {
      // A triangle that is as near, within one rounding, would have come first.
      EXPECT_GT(distanceOf(samples[n], mesh, before), nearest + epsilon * unit) << n;
    }
  }
  return worst;
}

} // namespace

TEST(InputPlaces, AreTheNearestOnesAndTheFirstOfThese)
{
  SCOPED_TRACE("seed 911");
  Random random(911);
  const Mesh meshes[] = {cube(), icosphere(2), torus(24, 12), triangleSoup(300, 911),
    surfaceOf(randomCells(3, 911)), moebiusStrip(20), tetrahedron().part(0, 1),
    torus(20, 8).mapped([](const Point& p) { return Point(p[0], p[1], 0); }), cube().with(cube())};
  double worst = 0;
  for (const Mesh& mesh : meshes)
  {
    const std::vector<Point> samples = samplesFor(mesh, random);
    worst = std::max(worst, worstOf(mesh, samples, placesOf({mesh.view()}, samples)));
  }
  record("largest distance beyond the nearest", worst);
  EXPECT_LT(worst, 1e-14); // measured: 1.3e-16
}

TEST(InputPlaces, AreTheSameByThreadsInAnyOrderAndAtAnyScale)
{
  SCOPED_TRACE("seed 912");
  Random random(912);
  const Mesh mesh = icosphere(3);
  std::vector<Point> samples;
  for (int n = 0; n < 20; ++n)
  {
    const std::vector<Point> some = samplesFor(mesh, random);
    samples.insert(samples.end(), some.begin(), some.end());
  }
  const std::vector<InputPlace> places = placesOf({mesh.view()}, samples);
  ShuffledThreads threads(912);
  const InputPlaces input({mesh.view()}, "", threads);
  std::vector<InputPlace> again(samples.size());
  input.find(
    samples.size(), [&](std::size_t n) { return samples[n]; }, again.data(), threads);
  std::vector<Point> backward(samples.rbegin(), samples.rend());
  const std::vector<InputPlace> reversed = placesOf({mesh.view()}, backward);
  for (const double factor : {0x1p-300, 0x1p300})
  {
    const Mesh scaled = mesh.scaled(factor);
    std::vector<Point> moved;
    for (const Point& sample : samples)
    {
      moved.push_back(factor * sample);
    }
    const std::vector<InputPlace> ofScaled = placesOf({scaled.view()}, moved);
    for (std::size_t n = 0; n < samples.size(); ++n)
    {
      ASSERT_EQ(ofScaled[n].primitive, places[n].primitive) << n << " times " << factor;
      ASSERT_EQ(ofScaled[n].weights, places[n].weights) << n << " times " << factor;
    }
  }
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    ASSERT_EQ(again[n].primitive, places[n].primitive) << n;
    ASSERT_EQ(again[n].weights, places[n].weights) << n;
    ASSERT_EQ(reversed[samples.size() - 1 - n].primitive, places[n].primitive) << n;
  }
}

TEST(InputPlaces, OfGridsAndOfManySamplesAreThoseOfEachSample)
{
  SCOPED_TRACE("seed 916");
  const Mesh meshes[] = {cube(), icosphere(3), torus(40, 20), triangleSoup(500, 916),
    surfaceOf(randomCells(4, 916)), cube().with(cube())};
  ShuffledThreads threads(916);
  for (const Mesh& mesh : meshes)
  {
    const InputPlaces input({mesh.view()}, "", threads);
    // Planes of the first grid go through the middles of cubes and spheres, where much is equal.
    for (const double shift : {0.0, 0.123})
    {
      winding::Grid grid;
      grid.firstSample = Point(-1.5 + shift, -1.5, -1.5);
      grid.spacing = Point(0.125, 0.125, 0.125);
      grid.dimensions = Eigen::Vector3i(25, 25, 25);
      const winding::Extent extent = {0, 24, 3, 24, 5, 20};
      const std::size_t count = winding::sampleCount(extent);
      std::vector<Point> samples;
      for (std::size_t n = 0; n < count; ++n)
      {
        samples.push_back(grid.sample(extent, n));
      }
      std::vector<InputPlace> onGrid(count), scattered(count);
      input.findOnGrid(grid, extent, onGrid.data(), threads);
      input.findAt({samples.front().data(), count}, scattered.data(), threads);
      const std::vector<InputPlace> each = placesOf(input, samples);
      for (std::size_t n = 0; n < count; ++n)
      {
        ASSERT_EQ(onGrid[n].primitive, each[n].primitive) << samples[n].transpose();
        ASSERT_EQ(scattered[n].primitive, each[n].primitive) << samples[n].transpose();
      }
    }
  }
}

TEST(InputPlaces, HaveTheNumbersOfTheInputWhereSomeIsUnusable)
{
  Mesh first = cube(), second = cube({3, 0, 0}, {4, 1, 1});
  first.triangles.insert(first.triangles.begin(), {0, 0, 1});        // has no area
  second.triangles.insert(second.triangles.begin() + 4, {0, 1, 99}); // has a bad id
  const Mesh empty;
  const std::vector<TrianglesView> views = {
    empty.view(), first.view(), empty.view(), second.view()};
  for (std::uint32_t view : {1, 3})
  {
    const Mesh& mesh = view == 1 ? first : second;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    {
      if (t == (view == 1 ? 0u : 4u))
      {
        continue;
      }
      Point center = Point::Zero();
      for (const std::int32_t corner : mesh.triangles[t])
      {
        center += mesh.points[static_cast<std::size_t>(corner)] / 3;
      }
      const InputPlace place = placesOf(views, {center}).front();
      EXPECT_EQ(place.view, view);
      EXPECT_EQ(place.primitive, t);
    }
  }
  // The first one counts where two cubes are in one place.
  EXPECT_EQ(placesOf({first.view(), first.view()}, {Point(0.3, 0.4, 2)}).front().view, 0u);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(placesOf(views, {Point(nan, 0, 0)}).front().exists());
  EXPECT_FALSE(placesOf(views, {Point(0, 1 / 0.0, 0)}).front().exists());
  EXPECT_FALSE(placesOf({empty.view()}, {Point(0, 0, 0)}).front().exists());
}

TEST(InputPlaces, OfMirroredSourcesLieInTheInput)
{
  SCOPED_TRACE("seed 913");
  Random random(913);
  const Mesh quarter = torus(24, 12).moved({2, 2, 0});
  const InputPlaces input({quarter.view()}, "x=0 y=0", serial);
  for (int n = 0; n < 300; ++n)
  {
    const Point sample = random.point(0.1, 4);
    const InputPlace own = placesOf(input, {sample}).front();
    for (const Point& signs : {Point(-1, 1, 1), Point(1, -1, 1), Point(-1, -1, 1)})
    {
      const InputPlace image = placesOf(input, {sample.cwiseProduct(signs)}).front();
      ASSERT_EQ(image.primitive, own.primitive);
      ASSERT_EQ(image.weights, own.weights);
    }
  }
}

TEST(InputPlaces, OfRowsLieInTheInput)
{
  // Four cubes in a row along x, made by parallel planes.
  const Mesh mesh = cube();
  const InputPlaces input({mesh.view()}, "x=0 x=1", serial);
  const Point own(0.25, 0.375, 1.5);
  const auto expected = placesOf(input, {own}).front();
  for (const double x : {-0.25, 1.75, 2.25})
  {
    const auto image = placesOf(input, {Point(x, own[1], own[2])}).front();
    EXPECT_EQ(image.primitive, expected.primitive) << x;
    EXPECT_EQ(image.weights, expected.weights) << x;
  }
}

TEST(InputPlaces, OfCloudsAreTheirNearestPoints)
{
  SCOPED_TRACE("seed 914");
  Random random(914);
  Cloud cloud = randomCloud(500, 914);
  cloud.positions.resize(550, cloud.positions[3]);
  cloud.normals.resize(550, cloud.normals[3]);
  const InputPlaces input({cloud.view()}, "", serial);
  for (int n = 0; n < 500; ++n)
  {
    const Point sample = n < 250 ? random.point(-2, 2) : cloud.positions[3 + n];
    const InputPlace place = placesOf(input, {sample}).front();
    ASSERT_TRUE(place.exists());
    ASSERT_LT(place.primitive, 500u) << "a point that is there again";
    const double distance = (sample - cloud.positions[place.primitive]).norm();
    ASSERT_LE(distance, naiveDistance(sample, cloud.positions) * (1 + 4 * epsilon));
  }
}

TEST(InputPlaces, OfAllThatIsEquallyNearTheFirstCounts)
{
  // All corners of an icosphere are equally far from its middle, up to rounding.
  Cloud cloud;
  cloud.positions = icosphere(5).points;
  cloud.normals = cloud.positions;
  const InputPlaces input({cloud.view()}, "", serial);
  EXPECT_EQ(placesOf(input, {Point(0, 0, 0)}).front().primitive, 0u);
}

TEST(InputPlaces, HaveWeightsOfThinTrianglesToo)
{
  SCOPED_TRACE("seed 915");
  Random random(915);
  double worst = 0;
  for (int n = 0; n < 20000; ++n)
  {
    const Point a = random.point(-1, 1), along = random.direction();
    const double thin = n % 3 == 0 ? 0 : std::pow(10, -random(0, 15));
    const Point b = a + along, c = a + random(-1, 2) * along + thin * random.direction();
    const Point sample = random.point(-2, 2);
    const std::array<double, 3> weights = winding::weightsOfNearest(sample, a, b, c);
    double sum = 0;
    for (const double weight : weights)
    {
      ASSERT_GE(weight, 0);
      sum += weight;
    }
    const Point point = weights[0] * a + weights[1] * b + weights[2] * c;
    worst = std::max(
      {worst, std::abs(sum - 1), (sample - point).norm() - naiveDistance(sample, a, b, c)});
  }
  record("largest error", worst);
  EXPECT_LT(worst, 1e-14); // measured: 8.9e-16
}
