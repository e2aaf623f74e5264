// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/Viewpoints.h"

#include "base/Refusal.h"
#include "cloud/NormalEstimation.h"
#include "cloud/OutwardNormals.h"

#include "support/Places.h"
#include "support/Samples.h"
#include "support/Serial.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace shapes;
using winding::Viewpoints;

std::vector<Point> normalsToward(const std::string& text, const std::vector<Point>& positions)
{
  const winding::DistinctPoints places = placesOf(positions);
  return winding::normalsToward(Viewpoints(text).directionsFrom(places, serial), places, 20, serial)
    .normals;
}

/// Adds points on a rectangle from `corner` along two edges, with noise across.
void addRectangle(Cloud& cloud, const Point& corner, const Point& a, const Point& b,
  const Point& normal, int count, Random& random)
{
  for (int i = 0; i < count; ++i)
  {
    const Point at{random(0, 1), random(0, 1), random(-0.01, 0.01)};
    cloud.positions.push_back(corner + at[0] * a + at[1] * b + at[2] * normal);
    cloud.normals.push_back(normal);
  }
}

/// Flat ground with a house of 4 x 4 x 3, seen from the air: ground, roof and, sparsely, walls.
Cloud houseFromTheAir()
{
  Random random(7);
  Cloud cloud;
  const double size = 12;
  for (int i = 0; i < 6000; ++i)
  {
    const Point at{random(-size, size), random(-size, size), random(-0.01, 0.01)};
    if (std::abs(at[0]) > 2 || std::abs(at[1]) > 2)
    {
      cloud.positions.push_back(at);
      cloud.normals.emplace_back(0, 0, 1);
    }
  }
  addRectangle(cloud, {-2, -2, 3}, {4, 0, 0}, {0, 4, 0}, {0, 0, 1}, 800, random);
  addRectangle(cloud, {-2, -2, 0}, {4, 0, 0}, {0, 0, 3}, {0, -1, 0}, 500, random);
  addRectangle(cloud, {-2, 2, 0}, {4, 0, 0}, {0, 0, 3}, {0, 1, 0}, 500, random);
  addRectangle(cloud, {-2, -2, 0}, {0, 4, 0}, {0, 0, 3}, {-1, 0, 0}, 500, random);
  addRectangle(cloud, {2, -2, 0}, {0, 4, 0}, {0, 0, 3}, {1, 0, 0}, 500, random);
  return cloud;
}

/// The inside of a room of 8 x 4 x 3 with a scanner in it, whose walls look inward.
Cloud room()
{
  Random random(11);
  Cloud cloud;
  addRectangle(cloud, {0, 0, 0}, {8, 0, 0}, {0, 4, 0}, {0, 0, 1}, 1500, random);
  addRectangle(cloud, {0, 0, 3}, {8, 0, 0}, {0, 4, 0}, {0, 0, -1}, 1500, random);
  addRectangle(cloud, {0, 0, 0}, {8, 0, 0}, {0, 0, 3}, {0, 1, 0}, 1200, random);
  addRectangle(cloud, {0, 4, 0}, {8, 0, 0}, {0, 0, 3}, {0, -1, 0}, 1200, random);
  addRectangle(cloud, {0, 0, 0}, {0, 4, 0}, {0, 0, 3}, {1, 0, 0}, 600, random);
  addRectangle(cloud, {8, 0, 0}, {0, 4, 0}, {0, 0, 3}, {-1, 0, 0}, 600, random);
  return cloud;
}

TEST(Viewpoints, NormalsOfARoomLookAtTheScanner)
{
  const Cloud cloud = room();
  EXPECT_EQ(rightShare(normalsToward("1 1 1.5", cloud.positions), cloud.normals), 1);
}

/// Walls are seen at right angles to their normals, which say nothing then: their senses come from
/// roof and ground, around the edges.
TEST(Viewpoints, NormalsFromTheAirLookUpAndThoseOfWallsOutward)
{
  const Cloud cloud = houseFromTheAir();
  const double share = rightShare(normalsToward("up", cloud.positions), cloud.normals);
  EXPECT_GE(share, 0.995) << share; // measured: 1; by the signs alone 0.907
}

TEST(Viewpoints, EachPointTakesTheNearestPosition)
{
  // A ring of two sheets back to back, each seen from its own side.
  Random random(3);
  Cloud cloud;
  addRectangle(cloud, {0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, -1}, 3000, random);
  addRectangle(cloud, {0, 0, 4}, {10, 0, 0}, {0, 10, 0}, {0, 0, 1}, 3000, random);
  const auto normals = normalsToward("2 2 -3; 8 8 -3; 2 2 7; 8 8 7", cloud.positions);
  EXPECT_EQ(rightShare(normals, cloud.normals), 1);
  EXPECT_NEAR(rightShare(normalsToward("5 5 7", cloud.positions), cloud.normals), 0.5, 0.01);
}

TEST(Viewpoints, TheOrderOfPointsAndThreadsMakeNoDifference)
{
  const Cloud cloud = houseFromTheAir();
  const std::string path = "3 0 9; -3 0 9; 3 0 9";
  const std::vector<Point> expected = normalsToward(path, cloud.positions);
  std::vector<Point> reversed(cloud.positions.rbegin(), cloud.positions.rend());
  ShuffledThreads threads(5);
  const winding::DistinctPoints places = placesOf(reversed);
  const auto directions = Viewpoints("-3 0 9; 3 0 9").directionsFrom(places, threads);
  std::vector<Point> normals = winding::normalsToward(directions, places, 20, threads).normals;
  std::reverse(normals.begin(), normals.end());
  EXPECT_EQ(normals, expected);
}

/// A wall that scanners see from both sides, as each point says: neighbours look opposite ways.
TEST(Viewpoints, OfEachPointDecide)
{
  Random random(5);
  Cloud cloud;
  addRectangle(cloud, {0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, -1}, 2000, random);
  const auto seenBy = [&cloud](const std::vector<Point>& scanners)
  {
    winding::PointCloud points;
    points.positions = cloud.positions;
    points.bounds = winding::Bounds(Point(0, 0, -0.01), Point(10, 10, 0.01));
    for (std::size_t i = 0; i < points.positions.size(); ++i)
    {
      points.normals.push_back((scanners[i % scanners.size()] - points.positions[i]).normalized());
    }
    const winding::OutwardNormals found = winding::giveOutwardNormals(
      points, winding::NormalEstimation::automatic, Viewpoints(), {}, serial);
    EXPECT_EQ(found.estimation, winding::NormalEstimation::toward);
    for (std::size_t i = 0; i < points.positions.size(); ++i)
    {
      EXPECT_GT(points.normals[i].dot(scanners[i % scanners.size()] - points.positions[i]), 0);
    }
    return found.opposed;
  };
  EXPECT_EQ(seenBy({{5, 5, 9}}), 0);
  EXPECT_EQ(seenBy({{5, 5, -9}}), 0);
  EXPECT_GT(seenBy({{5, 5, 9}, {5, 5, -9}}), 0.9);
}

TEST(Viewpoints, FewPointsHaveNormals)
{
  EXPECT_EQ(normalsToward("down", {{1, 2, 3}}).at(0), Point(0, 0, -1));
  EXPECT_EQ(normalsToward("1 2 3", {{1, 2, 3}}).at(0), Point(0, 0, 1));
  EXPECT_EQ(normalsToward("up", {}).size(), 0U);
}

TEST(Viewpoints, AreReadFromText)
{
  EXPECT_TRUE(Viewpoints("").empty());
  EXPECT_TRUE(Viewpoints(" ").empty());
  const winding::DistinctPoints origin = placesOf({{0, 0, 0}});
  for (const auto& [text, direction] : std::vector<std::pair<std::string, Point>>{{"up", {0, 0, 1}},
         {" -y ", {0, -1, 0}}, {"direction 0 -2 0", {0, -1, 0}}, {"3,0,0", {1, 0, 0}},
         {"1e300 0 0", {1, 0, 0}}, {"0 0 2; 0 9 0", {0, 0, 1}}})
  {
    EXPECT_EQ(Viewpoints(text).directionsFrom(origin, serial).at(0), direction) << text;
  }
  for (const char* const text : {"upward", "1 2", "1 2 3 4", "1 2 3; 4", "direction 0 0 0",
         "direction 1 2", "nan 0 0", "1 2 3 x", "; 1 2 3"})
  {
    EXPECT_THROW(Viewpoints{text}, winding::Refusal) << text;
  }
}

} // namespace
