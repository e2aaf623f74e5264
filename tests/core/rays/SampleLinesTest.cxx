// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/SampleLines.h"

#include "sums/ReferenceSum.h"
#include "support/HostileSoups.h"
#include "support/Serial.h"
#include "support/Shapes.h"
#include "support/Shuffled.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace
{

using namespace shapes;
using winding::SampleLine;
using winding::Surface;
using winding::SurfaceSample;
using winding::SurfaceSamples;

SurfaceSamples samplesOf(const Surface& surface, std::size_t most = 256)
{
  return sampleSurface(surface, most, serial);
}

std::vector<SampleLine> linesOf(const Surface& surface, const SurfaceSamples& samples)
{
  return linesThrough(surface, samples.points, samples, serial);
}

/// A ball with a dent and a bump, of 20 · 4^levels triangles.
Mesh lumpy(int levels)
{
  return icosphere(levels).mapped(
    [](const Point& p)
    {
      return Point(
        (1 + 0.3 * std::sin(4 * p[0]) * std::cos(3 * p[1])) * p + Point(0.1, 0.2, 0.3) * p[2]);
    });
}

} // namespace

TEST(SurfaceSamples, AreSpreadByArea)
{
  // Half of a slab's area is its top and its bottom, though most triangles are those of the ball.
  const Mesh both = cube({0, 0, 0}, {4, 4, 0.5}).with(icosphere(5).moved({10, 0, 0}));
  const Surface surface = clean(both);
  const double ofCube = 2 * 16 + 4 * 2.0, ofBall = 4 * M_PI;
  const SurfaceSamples samples = samplesOf(surface, 1024);
  double cubes = 0, all = 0;
  for (const SurfaceSample& sample : samples.points)
  {
    all += sample.weight;
    cubes += sample.position[0] < 5 ? sample.weight : 0;
    EXPECT_NEAR(sample.normal.norm(), 1, 1e-12);
  }
  EXPECT_NEAR(cubes / all, ofCube / (ofCube + ofBall), 0.03); // measured: 0.760 of 0.761
  EXPECT_GT(samples.points.size(), 900u);
  EXPECT_LE(samples.points.size(), 2048u);
  EXPECT_EQ(samplesOf(clean(cube()), 1024).points.size(), 252u) << "64, and 16 for each triangle";
  EXPECT_TRUE(samplesOf(Surface()).points.empty());
}

TEST(SurfaceSamples, DependOnTheSetOfTriangles)
{
  const Mesh mesh = lumpy(6).with(cube().moved({3, 0, 0}));
  const auto keysOf = [](const Mesh& of)
  {
    const Surface surface = clean(of);
    std::vector<std::tuple<double, double, double, double>> keys;
    const SurfaceSamples samples = samplesOf(surface, 512);
    for (const SurfaceSample& sample : samples.points)
    {
      keys.emplace_back(
        sample.position[0], sample.position[1], sample.position[2], sample.normal[0]);
    }
    EXPECT_FALSE(samples.some.empty());
    EXPECT_NEAR(static_cast<double>(samples.some.size()),
      samples.shareOfSome * static_cast<double>(surface.triangles.size()),
      0.1 * static_cast<double>(samples.some.size()));
    std::sort(keys.begin(), keys.end());
    return keys;
  };
  const auto keys = keysOf(mesh);
  for (const unsigned seed : {1u, 2u, 3u})
  {
    Random random(seed);
    EXPECT_EQ(keysOf(shuffled(mesh, [&random](std::size_t n) { return random.bits() % n; })), keys)
      << seed;
  }
}

TEST(SampleLines, GiveTheWindingNumbersOnBothSides)
{
  const Mesh ball = icosphere(3);
  const Mesh small = ball.mapped([](const Point& p) { return Point(p / 2); });
  const Mesh cavity = ball.with(small.reversed());
  const Mesh twice = ball.with(ball.moved({0.5, 0.2, 0.1}));
  for (const Mesh& mesh : {lumpy(4), lumpy(3).reversed(), cavity, twice, torus(40, 20), cube(),
         surfaceOf(randomCells(4, 5))})
  {
    const Surface surface = clean(mesh);
    const SurfaceSamples samples = samplesOf(surface, 64);
    const std::vector<SampleLine> lines = linesOf(surface, samples);
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
      const SurfaceSample& sample = samples.points[i];
      EXPECT_TRUE(lines[i].isClear());
      const Point step = 1e-5 * sample.normal;
      EXPECT_NEAR(
        winding::referenceSum<double>(surface, sample.position + step), lines[i].before, 1e-3);
      EXPECT_NEAR(
        winding::referenceSum<double>(surface, sample.position - step), lines[i].behind, 1e-3);
    }
  }
}

TEST(SampleLines, CrossClosedChainsAsOftenEitherWay)
{
  // Each triangle of a closed chain shares its edges with others that decide as it does.
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    SCOPED_TRACE(seed);
    Mesh mesh = latticeSoup(200, 5, seed);
    const Mesh soup = mesh;
    for (const auto& t : soup.triangles)
    {
      const auto apex = static_cast<std::int32_t>(mesh.points.size() - 1 - seed % 7);
      for (int i = 0; i < 3; ++i)
      {
        mesh.triangles.push_back({t[(i + 1) % 3], t[i], apex});
      }
    }
    const Surface surface = clean(mesh);
    ASSERT_TRUE(boundaryOf(surface).edges.empty());
    for (const SampleLine& line : linesOf(surface, samplesOf(surface)))
    {
      EXPECT_TRUE(line.isClear());
    }
  }
}

TEST(SampleLines, MeasureWalls)
{
  const auto wallsOf = [](const Mesh& mesh)
  {
    const Surface surface = clean(mesh);
    std::vector<double> walls;
    for (const SampleLine& line : linesOf(surface, samplesOf(surface)))
    {
      walls.push_back(line.wall);
    }
    std::sort(walls.begin(), walls.end());
    return walls;
  };
  const auto turned = [](const Mesh& mesh)
  {
    const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Point(1, 2, 3).normalized()).toRotationMatrix();
    return mesh.mapped([&](const Point& p) -> Point { return turn * p; });
  };
  const std::vector<double> ofPlate = wallsOf(turned(cube({0, 0, 0}, {1, 1, 0.02})));
  EXPECT_NEAR(ofPlate[ofPlate.size() / 10], 0.02, 1e-9);
  EXPECT_NEAR(ofPlate[ofPlate.size() / 2], 0.02, 1e-9);
  const Mesh rod = lathe({{0, 0}, {0.1, 0}, {0.1, 5}, {0, 5}}, 64);
  const std::vector<double> ofRod = wallsOf(turned(rod));
  EXPECT_GT(ofRod[ofRod.size() / 10], 0.12); // measured: 0.7 times 0.2 and more
  EXPECT_LT(ofRod[ofRod.size() / 2], 0.21);
  const std::vector<double> ofCube = wallsOf(turned(cube()));
  EXPECT_GT(ofCube[ofCube.size() / 50], 0.5) << "sides at right angles are no wall";
}

TEST(SampleLines, SeeFacesThatAreThereAgain)
{
  // The second copy of each square is cut along the other diagonal, and looks the other way.
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 0, 3}, {1, 3, 2}};
  const Surface surface = clean(mesh);
  for (const SampleLine& line : linesOf(surface, samplesOf(surface)))
  {
    EXPECT_TRUE(line.isRepeated);
    EXPECT_EQ(line.step, 0);
    EXPECT_EQ(line.facesBefore + line.facesBehind, 0);
  }
}
