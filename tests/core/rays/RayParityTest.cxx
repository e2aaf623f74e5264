// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/RayParity.h"

#include "source/Surface.h"
#include "sums/DirectSum.h"
#include "support/LatticeSolids.h"
#include "support/Shapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace shapes;

std::vector<double> parityOf(const Mesh& mesh, const std::vector<Point>& samples)
{
  const winding::Surface surface = clean(mesh);
  return valuesOf(winding::RayParity(surface), samples);
}

std::vector<double> windingOf(const Mesh& mesh, const std::vector<Point>& samples)
{
  const winding::Surface surface = clean(mesh);
  return valuesOf(winding::TriangleSum(surface), samples);
}

/// Samples that share two coordinates with vertices and middles of edges, so that rays hit these.
std::vector<Point> rayHitsEdgesAndVertices(const Mesh& mesh, unsigned seed)
{
  Random random(seed);
  std::vector<Point> samples;
  for (const auto& t : mesh.triangles)
  {
    const Point &a = mesh.points[t[0]], &b = mesh.points[t[1]];
    samples.emplace_back(random(-2, 2), a[1], a[2]);
    const Point middle = 0.5 * (a + b);
    samples.emplace_back(random(-2, 2), middle[1], middle[2]);
    samples.emplace_back(random(-2, 2), a[1], b[2]);
  }
  return samples;
}

} // namespace

TEST(RayParity, IsOneInsideAndZeroOutsideOfLatticeSolidsWhateverTheRaysHit)
{
  SCOPED_TRACE("seed 61");
  for (const LatticeSolid& solid : latticeSolids(61))
  {
    const std::vector<double> parities = parityOf(solid.mesh, solid.samples);
    for (std::size_t i = 0; i < parities.size(); ++i)
    {
      if (solid.isOff(i))
      {
        ASSERT_EQ(parities[i], solid.windings[i]) << solid.samples[i].transpose();
      }
    }
  }
}

TEST(RayParity, AgreesWithTheDirectSumWhereRaysHitEdgesAndVertices)
{
  SCOPED_TRACE("seed 62");
  for (const Mesh& mesh : {tetrahedron(), icosphere(3), torus(48, 24)})
  {
    const std::vector<Point> samples = rayHitsEdgesAndVertices(mesh, 62);
    const std::vector<double> expected = windingOf(mesh, samples);
    const std::vector<double> values = parityOf(mesh, samples);
    std::size_t compared = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      // Samples on the surface itself have no right answer.
      if (std::abs(expected[i] - std::round(expected[i])) < 1e-9)
      {
        ++compared;
        ASSERT_EQ(values[i], std::round(expected[i])) << samples[i].transpose();
      }
    }
    EXPECT_GT(compared, samples.size() / 2);
  }
}

TEST(RayParity, AgreesWithTheDirectSumCloseToTheSurface)
{
  SCOPED_TRACE("seed 63");
  for (const Mesh& mesh : {icosphere(3), torus(48, 24)})
  {
    for (const double distance : {1e-3, 1e-6, 1e-9, 1e-12})
    {
      const std::vector<Point> samples = pointsNear(mesh, 1000, distance, 63);
      const std::vector<double> expected = windingOf(mesh, samples);
      const std::vector<double> values = parityOf(mesh, samples);
      for (std::size_t i = 0; i < samples.size(); ++i)
      {
        ASSERT_EQ(values[i], std::round(expected[i])) << distance;
      }
    }
  }
}

TEST(RayParity, IsRightBesideTrianglesThatAreAlongTheRayUpToRounding)
{
  SCOPED_TRACE("seed 64");
  Random random(64);
  for (int i = 0; i < 20000; ++i)
  {
    // Triangle a b c lies along the ray up to the rounding of its corners, and the sample lies in
    // its plane, up to rounding, in front of it or behind it and far from the solid.
    const Point a = Point{0, random(-1, 1), random(-1, 1)};
    const Point along = Point{0, random(-1, 1), random(-1, 1)};
    const Point ray = Point::UnitX();
    const Point b = a + along + ray, c = a + 2 * along;
    const Point d = a + Point(0.5, -along[2], along[1]);
    const Mesh mesh{{a, b, c, d}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
    const double place = random(0.1, 0.5);
    const Point q = a + place * along + 0.9 * ray;
    ASSERT_EQ(parityOf(mesh, {q})[0], 0) << i << ' ' << windingOf(mesh, {q})[0];
  }
}

TEST(RayParity, IgnoresOrientation)
{
  SCOPED_TRACE("seed 65");
  Mesh flipped = torus(24, 12);
  for (std::size_t i = 0; i < flipped.triangles.size(); i += 3)
  {
    std::swap(flipped.triangles[i][0], flipped.triangles[i][1]);
  }
  const std::vector<Point> samples = randomPoints(1000, -1.5, 1.5, 65);
  EXPECT_EQ(parityOf(flipped, samples), parityOf(torus(24, 12), samples));
}

TEST(RayParity, IsZeroAgainWhereTwoSolidsOverlap)
{
  const Mesh two = cube().with(cube({0.5, 0.5, 0.5}, {1.5, 1.5, 1.5}));
  const std::vector<Point> samples = {
    {0.25, 0.25, 0.25}, {0.75, 0.75, 0.75}, {1.25, 1.25, 1.25}, {0.25, 0.75, 1.25}};
  EXPECT_EQ(parityOf(two, samples), (std::vector<double>{1, 0, 1, 0}));
}

TEST(RayParity, IsZeroOrOneOnTheSurface)
{
  const Mesh mesh = surfaceOf(lShape());
  std::vector<Point> samples = mesh.points;
  for (const auto& t : mesh.triangles)
  {
    samples.push_back(0.5 * (mesh.points[t[0]] + mesh.points[t[1]]));
    samples.push_back((mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3);
  }
  for (const double value : parityOf(mesh, samples))
  {
    ASSERT_TRUE(value == 0 || value == 1);
  }
}

TEST(RayParity, DoesNotDependOnTheUnitOfLengthOrTheDistanceFromTheOrigin)
{
  SCOPED_TRACE("seed 66");
  const std::vector<Point> samples = randomPoints(500, -1.5, 1.5, 66);
  const std::vector<double> expected = parityOf(icosphere(2), samples);
  const auto mapped = [&](const std::function<Point(const Point&)>& map)
  {
    std::vector<Point> moved(samples.size());
    std::transform(samples.begin(), samples.end(), moved.begin(), map);
    return moved;
  };
  for (const double scale : {1e-200, 1e-30, 1e-6, 1e6, 1e30, 1e200})
  {
    const winding::Surface scaled = cleanScaled(icosphere(2), scale);
    const auto toScale = [&](const Point& p) -> Point
    {
      return scale * p;
    };
    EXPECT_EQ(valuesOf(winding::RayParity(scaled), mapped(toScale)), expected) << scale;
  }
  const auto away = [](const Point& p) -> Point
  {
    return p + Point(4e6, -3e6, 5e6);
  };
  EXPECT_EQ(parityOf(icosphere(2).mapped(away), mapped(away)), expected);
}
