// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/// Normals of solids that lie in each other: walls within other solids keep their senses, cavities
/// do, too, and automatic normals are about as good as either way of finding them.

#include "cloud/OverlappingNormals.h"

#include "cloud/NormalEstimation.h"
#include "cloud/OutwardNormals.h"
#include "cloud/OverlapSigns.h"
#include "cloud/PatchSigns.h"
#include "cloud/PlaceNormals.h"
#include "support/Places.h"
#include "support/Samples.h"
#include "support/Serial.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <numeric>
#include <random>

namespace
{

using namespace shapes;

constexpr int neighbors = 20;

/// Adds points of a sphere, with normals that point outward, or inward for a cavity.
void addSphere(Cloud& cloud, std::size_t count, const Point& center, double radius, Random& random,
  int sense = 1)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const Point normal = random.direction();
    cloud.positions.push_back(center + radius * normal);
    cloud.normals.push_back(sense * normal);
  }
}

/// Adds points of a box, as many as suit the areas of its faces.
void addBox(Cloud& cloud, std::size_t count, const Point& low, const Point& high, Random& random)
{
  const Point size = high - low;
  const double areas[] = {size[1] * size[2], size[2] * size[0], size[0] * size[1]};
  for (std::size_t i = 0; i < count; ++i)
  {
    const double choice = random(0, areas[0] + areas[1] + areas[2]);
    const int axis = choice < areas[0] ? 0 : choice < areas[0] + areas[1] ? 1 : 2;
    const bool isHigh = random(0, 1) < 0.5;
    Point position{random(low[0], high[0]), random(low[1], high[1]), random(low[2], high[2])};
    position[axis] = isHigh ? high[axis] : low[axis];
    cloud.positions.push_back(position);
    cloud.normals.push_back((isHigh ? 1 : -1) * Point::Unit(axis));
  }
}

Cloud twoBalls()
{
  Cloud cloud;
  Random random(341);
  addSphere(cloud, 3000, Point(0, 0, 0), 1, random);
  addSphere(cloud, 3000, Point(1, 0.1, 0.2), 1, random);
  return cloud;
}

/// A cube with a ball at each of its corners.
Cloud cubeWithBalls()
{
  Cloud cloud;
  Random random(342);
  addBox(cloud, 4000, Point(-1, -1, -1), Point(1, 1, 1), random);
  for (int corner = 0; corner < 8; ++corner)
  {
    const Point center(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    addSphere(cloud, 800, center, 0.6, random);
  }
  return cloud;
}

/// Plates that pass through a ball, with gaps between them as thick as they are.
Cloud ballWithPlates()
{
  Cloud cloud;
  Random random(343);
  addSphere(cloud, 5000, Point(0, 0, 0), 1, random);
  for (int i = 0; i < 3; ++i)
  {
    const double low = 0.32 * i - 0.4;
    addBox(cloud, 4000, Point(-1.5, -1.2, low), Point(1.5, 1.2, low + 0.16), random);
  }
  return cloud;
}

/// A ball with a cavity, in which there is another ball.
Cloud shells()
{
  Cloud cloud;
  Random random(344);
  addSphere(cloud, 3000, Point(0, 0, 0), 1, random);
  addSphere(cloud, 2000, Point(0, 0, 0), 0.8, random, -1);
  addSphere(cloud, 1000, Point(0, 0, 0), 0.5, random);
  return cloud;
}

double rightShare(const Cloud& cloud, winding::NormalEstimation estimation)
{
  winding::PointCloud given = clean(cloud);
  given.normals.clear();
  winding::giveOutwardNormals(given, estimation, {}, {}, serial);
  return shapes::rightShare(given.normals, cloud.normals);
}

/// Normals by the spanning tree, turned outward.
std::vector<Point> byTree(const Cloud& cloud)
{
  winding::PointCloud given = clean(cloud);
  given.normals.clear();
  winding::giveOutwardNormals(given, winding::NormalEstimation::spanningTree, {}, {}, serial);
  return given.normals;
}

/// A cloud, and what judges its normals.
struct Judged
{
  explicit Judged(const Cloud& given)
    : cloud(given)
    , places(placesOf(cloud.positions))
    , graph(places, neighbors, serial)
    , overlapping(places, graph, serial)
  {
  }

  winding::OverlappingNormals::Found improved() const
  {
    return overlapping.improved(winding::normalsByPlace(places, byTree(cloud)));
  }

  /// Returns the faults of right normals after some are turned round.
  double faultsWith(const std::function<bool(const Point&)>& isTurned) const
  {
    std::vector<Point> normals = cloud.normals;
    for (std::size_t i = 0; i < normals.size(); ++i)
    {
      normals[i] *= isTurned(cloud.positions[i]) ? -1 : 1;
    }
    return overlapping.faultsOf(winding::normalsByPlace(places, normals));
  }

  const Cloud cloud;
  const winding::DistinctPoints places;
  const winding::NeighborGraph graph;
  const winding::OverlappingNormals overlapping;
};

} // namespace

TEST(OverlappingNormals, MakeAutomaticOnesAboutAsGoodAsEitherOtherWay)
{
  using winding::NormalEstimation;
  // By the tree, consistent and automatic: 0.9995, 0.764 and 0.9992; 0.984, 0.837 and 0.981; 0.673,
  // 0.893 and 0.982; 0.667, 1 and 1. Automatic ones were the consistent ones of the second and the
  // third cloud.
  for (const Cloud& cloud : {twoBalls(), cubeWithBalls(), ballWithPlates(), shells()})
  {
    const double tree = rightShare(cloud, NormalEstimation::spanningTree);
    const double consistent = rightShare(cloud, NormalEstimation::consistent);
    const double automatic = rightShare(cloud, NormalEstimation::automatic);
    EXPECT_GT(automatic, std::max(tree, consistent) - 0.02);
    EXPECT_GT(automatic, 0.97);
  }
}

TEST(OverlappingNormals, HaveFewFaultsThoughWallsAreWithinSolids)
{
  const Judged balls(twoBalls());
  const auto isWithinTheOther = [](const Point& p)
  {
    return p.norm() < 0.999 || (p - Point(1, 0.1, 0.2)).norm() < 0.999;
  };
  const double right = balls.faultsWith([](const Point&) { return false; });
  const double turned = balls.faultsWith(isWithinTheOther);
  EXPECT_LT(right, 0.006);  // 0.0046
  EXPECT_GT(turned, 0.018); // 0.0211
  EXPECT_TRUE(winding::areFarMore(turned, right));
  EXPECT_LT(balls.improved().faults, 0.008); // 0.0066
}

TEST(OverlappingNormals, HaveAboutTheSameFaultsForACavityAndASolid)
{
  const Judged hollow(shells());
  const double right = hollow.faultsWith([](const Point&) { return false; });
  const double solid =
    hollow.faultsWith([](const Point& p) { return p.norm() > 0.6 && p.norm() < 0.9; });
  EXPECT_LT(right, 0.001); // 0.0006
  EXPECT_LT(solid, 0.001); // 0.0005
  const winding::OverlappingNormals::Found found = hollow.improved();
  EXPECT_LT(found.faultsByParity, 0.001); // 0.0007
  EXPECT_FALSE(winding::areFarMore(found.faultsByParity, found.faults));
}

TEST(OverlappingNormals, HaveFarMoreFaultsByParityWhereSolidsMeet)
{
  const winding::OverlappingNormals::Found found = Judged(cubeWithBalls()).improved();
  record("faults", found.faults);
  record("faultsByParity", found.faultsByParity);
  EXPECT_TRUE(winding::areFarMore(found.faultsByParity, found.faults));
}

TEST(OverlappingNormals, HaveTheSameBitsForAnyThreadsAndOrder)
{
  SCOPED_TRACE("seed 345");
  const Cloud cloud = cubeWithBalls();
  const Judged judged(cloud);
  const winding::OverlappingNormals::Found expected = judged.improved();
  std::vector<std::size_t> order(cloud.positions.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(7));
  const std::vector<Point> tree = byTree(cloud);
  std::vector<Point> positions, senses;
  for (const std::size_t point : order)
  {
    positions.push_back(cloud.positions[point]);
    senses.push_back(tree[point]);
  }
  ShuffledThreads threads(345);
  const winding::DistinctPoints places = placesOf(positions);
  const winding::NeighborGraph graph(places, neighbors, threads);
  const winding::OverlappingNormals shuffled(places, graph, threads);
  const auto found = shuffled.improved(winding::normalsByPlace(places, senses));
  EXPECT_EQ(found.faults, expected.faults);
  EXPECT_EQ(found.faultsByParity, expected.faultsByParity);
  EXPECT_EQ(found.normals, expected.normals);
}

TEST(OverlappingNormals, OfNoisyPointsAreThoseOfSomeThatAreMovedOntoPlanes)
{
  SCOPED_TRACE("seed 346");
  using winding::NormalEstimation;
  Cloud cloud = cubeWithBalls();
  Random random(346);
  for (Point& position : cloud.positions)
  {
    position += 0.04 * Point{random.normal(), random.normal(), random.normal()};
  }
  const double tree = rightShare(cloud, NormalEstimation::spanningTree);
  const double consistent = rightShare(cloud, NormalEstimation::consistent);
  const double automatic = rightShare(cloud, NormalEstimation::automatic);
  EXPECT_GT(automatic, std::max(tree, consistent) - 0.02);
  EXPECT_GT(automatic, 0.95); // 0.965; by the tree 0.594, consistent 0.824, which it was

  // The bits are the same for any threads and order.
  winding::PointCloud given = clean(cloud);
  given.normals.clear();
  winding::PointCloud reversed = given;
  std::reverse(reversed.positions.begin(), reversed.positions.end());
  winding::giveOutwardNormals(given, NormalEstimation::automatic, {}, {}, serial);
  ShuffledThreads threads(346);
  winding::giveOutwardNormals(reversed, NormalEstimation::automatic, {}, {}, threads);
  std::reverse(reversed.normals.begin(), reversed.normals.end());
  EXPECT_EQ(reversed.normals, given.normals);
}

TEST(OverlappingNormals, OfTwoPlacesAreFinite)
{
  const Judged two(Cloud{{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}, {0, 0, 1}}});
  for (const Point& normal : two.improved().normals)
  {
    EXPECT_NEAR(normal.norm(), 1, 1e-12);
  }
}

TEST(OverlapSigns, KeepWallsWithinOtherSolids)
{
  // Slabs without end from 0 to 2 and from 1 to 3: w is 1/2, 3/2, 3/2 and 1/2 at their walls.
  const double outward[] = {1, 1, -1, -1}; // at walls whose solids begin there, and end there
  Eigen::Matrix4d shares;
  for (int at = 0; at < 4; ++at)
  {
    for (int wall = 0; wall < 4; ++wall)
    {
      shares(at, wall) = at == wall ? 0 : (at > wall ? 0.5 : -0.5) * outward[wall];
    }
  }
  const Eigen::Vector4d right(1, 1, 1, 1), byHalves(1, -1, -1, 1);
  EXPECT_EQ(winding::patchSigns(shares), byHalves);
  const winding::OverlapSigns overlap(shares, Eigen::Matrix4d::Zero());
  EXPECT_EQ(overlap.improved(right), right);
  EXPECT_EQ(overlap.improved(Eigen::Vector4d(1, 1, 1, -1)), right);
  EXPECT_EQ(winding::faultsAtWalls(overlap.valuesOf(right)), 0);
  // Bonds decide where the field does not, and two signs are turned at once.
  Eigen::Matrix4d bonds = Eigen::Matrix4d::Zero();
  for (int wall = 0; wall < 3; ++wall)
  {
    bonds(wall, wall + 1) = bonds(wall + 1, wall) = 0.001;
  }
  EXPECT_EQ(winding::OverlapSigns(shares, bonds).improved(byHalves), right);
}

TEST(OverlapSigns, FollowBondsWhereTheFieldSaysNothing)
{
  Eigen::MatrixXd shares = Eigen::MatrixXd::Zero(4, 4), bonds = shares;
  shares.col(0).setConstant(0.5);
  const auto bind = [&](Eigen::Index first, Eigen::Index second, double bond)
  {
    bonds(first, second) = bonds(second, first) = bond;
  };
  bind(0, 1, 0.01);
  bind(1, 2, -0.01);
  bind(2, 3, 0.01);
  const Eigen::Vector4d expected(1, 1, -1, -1);
  EXPECT_EQ(
    winding::OverlapSigns(shares, bonds).improved(Eigen::Vector4d(1, -1, -1, -1)), expected);
  EXPECT_EQ(winding::OverlapSigns(shares, bonds).improved(Eigen::Vector4d(1, 1, 1, 1)), expected);
}

TEST(OverlapSigns, HaveNoFaultsWhereSolidsAreAround)
{
  EXPECT_EQ(winding::faultAtWall(0.5), 0);
  EXPECT_EQ(winding::faultAtWall(3.5), 0);
  EXPECT_EQ(winding::faultAtWall(2), 0.25);
  EXPECT_EQ(winding::faultAtWall(-0.5), 1);
}
