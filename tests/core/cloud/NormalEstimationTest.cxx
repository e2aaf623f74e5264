// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/NormalEstimation.h"

#include "cloud/NeighborGraph.h"

#include "support/Places.h"
#include "support/Samples.h"
#include "support/Serial.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace shapes;

std::vector<Point> estimate(const std::vector<Point>& positions, int neighbors = 20)
{
  return winding::estimateNormals(placesOf(positions), neighbors, serial);
}

/// The share of normals on the same side as expected, or of those on the other side if they are
/// more.
double consistentShare(const std::vector<Point>& normals, const std::vector<Point>& expected)
{
  std::size_t same = 0;
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    same += normals[i].dot(expected[i]) > 0;
  }
  return static_cast<double>(std::max(same, normals.size() - same)) /
         static_cast<double>(normals.size());
}

/// A cloud of random points on a torus of radii 1 and 0.4.
Cloud torusCloud(std::size_t count, unsigned seed)
{
  Random random(seed);
  Cloud cloud;
  while (cloud.positions.size() < count)
  {
    const double along = random(0, 6.283185307179586), around = random(0, 6.283185307179586);
    const double radius = 1 + 0.4 * std::cos(around);
    if (random(0, 1.4) < radius)
    {
      const Point out(std::cos(along), std::sin(along), 0);
      cloud.normals.push_back(std::cos(around) * out + std::sin(around) * Point(0, 0, 1));
      cloud.positions.push_back(out + 0.4 * cloud.normals.back());
    }
  }
  return cloud;
}

void expectUnit(const std::vector<Point>& normals)
{
  for (const Point& normal : normals)
  {
    EXPECT_NEAR(normal.norm(), 1, 1e-12);
  }
}

} // namespace

TEST(NormalEstimation, FindsTheNormalsOfSmoothSolidsOutward)
{
  SCOPED_TRACE("seed 91");
  for (const Cloud& cloud : {sphereCloud(3000), torusCloud(8000, 91)})
  {
    const std::vector<Point> normals = estimate(cloud.positions);
    double worst = 1;
    for (std::size_t i = 0; i < normals.size(); ++i)
    {
      worst = std::min(worst, normals[i].dot(cloud.normals[i]));
    }
    record("worstCosine" + std::to_string(cloud.positions.size()), worst);
    EXPECT_GT(worst, 0.9); // measured: 0.9998 and 0.972
    expectUnit(normals);
  }
}

TEST(NormalEstimation, OrientsTwoSheetsThatAreFartherApartThanTheirPoints)
{
  SCOPED_TRACE("seed 92");
  // The two sheets of a plate with rounded rims are joined around these.
  Random random(92);
  Cloud plate;
  while (plate.positions.size() < 20'000)
  {
    const Point p = random.direction();
    const Point squeezed = p.cwiseProduct(Point(1, 1, 0.1));
    plate.positions.push_back(squeezed);
    plate.normals.push_back(p.cwiseQuotient(Point(1, 1, 0.1)).normalized());
  }
  const double share = consistentShare(estimate(plate.positions), plate.normals);
  record("share", share);
  EXPECT_GT(share, 0.999); // measured: 1
}

TEST(NormalEstimation, TurnsEveryPieceUpAtItsTop)
{
  Cloud two = sphereCloud(1000);
  for (std::size_t i = 0; i < 1000; ++i)
  {
    two.positions.push_back(two.positions[i] + Point(100, 50, -30));
    two.normals.push_back(two.normals[i]);
  }
  const std::vector<Point> normals = estimate(two.positions);
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    EXPECT_GT(normals[i].dot(two.normals[i]), 0.9);
  }
}

TEST(NormalEstimation, TurnsAPointLikeItsNeighborsThoughItIsNoneOfTheirs)
{
  // The lowest point of a sphere stands alone: the points nearest to it have enough others that are
  // nearer to them. A piece of its own would be turned up.
  const Cloud sphere = sphereCloud(3000);
  std::vector<Point> positions;
  for (const Point& position : sphere.positions)
  {
    if (position[2] > -0.8)
    {
      positions.push_back(position);
    }
  }
  positions.emplace_back(0, 0, -1);
  EXPECT_LT(estimate(positions).back()[2], -0.9);
}

TEST(PlacePlanes, HaveTheDeviationOfTheNoise)
{
  SCOPED_TRACE("seed 47");
  Random random(47);
  constexpr double noise = 1e-3;
  std::vector<Point> positions;
  for (int n = 0; n < 20000; ++n)
  {
    // The sum of twelve has a variance of 1.
    double sum = -6;
    for (int i = 0; i < 12; ++i)
    {
      sum += random(0, 1);
    }
    positions.push_back({random(0, 100), random(0, 100), noise * sum});
  }
  const winding::DistinctPoints places = placesOf(positions);
  for (const std::size_t neighbors : {6u, 20u})
  {
    const std::vector<double> deviations =
      winding::placePlanes(places, neighbors, serial).deviations;
    double variance = 0;
    for (const double deviation : deviations)
    {
      variance += deviation * deviation / static_cast<double>(deviations.size());
    }
    // Places are in other units. Measured: 0.987 and 0.983.
    const double unit = noise * winding::unitScaleOf(positions);
    EXPECT_NEAR(variance / (unit * unit), 1, 0.03) << neighbors;
  }
}

TEST(NormalEstimation, IsNotSpoiledByAFarOutlierOrEqualPoints)
{
  Cloud cloud = sphereCloud(2000);
  cloud.positions.insert(cloud.positions.end(), 100'000, cloud.positions[7]);
  cloud.normals.insert(cloud.normals.end(), 100'000, cloud.normals[7]);
  cloud.positions.push_back({1e7, 0, 0});
  cloud.normals.push_back({1, 0, 0});
  const std::vector<Point> normals = estimate(cloud.positions);
  for (std::size_t i = 0; i + 1 < normals.size(); ++i)
  {
    ASSERT_GT(normals[i].dot(cloud.normals[i]), 0.9) << i;
  }
}

TEST(NormalEstimation, GivesUnitNormalsWhateverThePoints)
{
  SCOPED_TRACE("seed 93");
  std::vector<Point> line, equal(100, Point(1, 2, 3)), flat;
  for (int i = 0; i < 100; ++i)
  {
    line.emplace_back(i, 2 * i, 3 * i);
    flat.emplace_back(i % 10, i / 10, 0);
  }
  for (const auto& positions : {std::vector<Point>(), std::vector<Point>{{1, 2, 3}},
         std::vector<Point>{{0, 0, 0}, {1e-200, 0, 0}}, line, equal, flat,
         randomPoints(500, -1e30, 1e30, 93), randomPoints(500, -1e-30, 1e-30, 93)})
  {
    const std::vector<Point> normals = estimate(positions);
    EXPECT_EQ(normals.size(), positions.size());
    expectUnit(normals);
  }
  for (const Point& normal : estimate(line))
  {
    EXPECT_NEAR(normal.dot(Point(1, 2, 3).normalized()), 0, 1e-9);
  }
  for (const Point& normal : estimate(flat))
  {
    EXPECT_NEAR(normal[2], 1, 1e-12);
  }
}

TEST(NormalEstimation, TakesNoMemoryForManyNeighbors)
{
  const Cloud cloud = sphereCloud(2000);
  const winding::DistinctPoints places(cloud.positions, 1, serial);
  const winding::NeighborGraph graph(places, 1000, serial);
  EXPECT_EQ(graph.neighborsPerPlace(), 40u);
  // Planes go through all neighbours all the same: few are on one level of a step, all on both.
  std::vector<Point> step;
  for (int i = 0; i < 200; ++i)
  {
    step.emplace_back(0.01 * (i % 20), 0.05 * (i / 20), 0);
    step.emplace_back(0.5 + 0.01 * (i % 20), 0.05 * (i / 20), 0.5);
  }
  const winding::DistinctPoints steps(step, 1, serial);
  const winding::NeighborGraph few(steps, 1000, serial);
  const std::vector<Point> flat = winding::planeNormals(steps, few, 20, serial);
  const std::vector<Point> oblique = winding::planeNormals(steps, few, 399, serial);
  for (std::size_t i = 0; i < flat.size(); ++i)
  {
    EXPECT_NEAR(std::abs(flat[i][2]), 1, 1e-9);
    EXPECT_NEAR(std::abs(oblique[i][2]), std::sqrt(0.5), 0.05);
  }
}

TEST(NormalEstimation, DoesNotDependOnTheThreads)
{
  SCOPED_TRACE("seeds 94, 95");
  const std::vector<Point> positions = randomPoints(3000, -1, 1, 94);
  ShuffledThreads threads(95);
  EXPECT_EQ(winding::estimateNormals(placesOf(positions), 20, threads), estimate(positions));
}
