// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "source/SourceVolume.h"

#include "support/Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{

using namespace shapes;
using winding::PointCloud;
using winding::Surface;

TEST(SourceVolume, IsThatOfClosedSurfaces)
{
  const Mesh box = cube(Point(1, 2, 3), Point(3, 5, 7));
  EXPECT_NEAR(winding::volumeOf(clean(box)), 24, 1e-12);
  EXPECT_NEAR(winding::volumeOf(clean(box.reversed())), 24, 1e-12);
  const Mesh hollow = box.with(cube(Point(1.5, 3, 4), Point(2.5, 4, 5)).reversed());
  EXPECT_NEAR(winding::volumeOf(clean(hollow)), 23, 1e-12);
  EXPECT_EQ(winding::volumeOf(Surface()), 0);
  EXPECT_EQ(winding::volumeOf(PointCloud()), 0);
}

TEST(SourceVolume, HasTheSameBitsForAnyOrderOfTriangles)
{
  Surface surface =
    clean(icosphere(3).mapped([](const Point& p) { return Point(0.1 * p.array() + 7); }));
  const double volume = winding::volumeOf(surface);
  EXPECT_NEAR(volume, 0.001 * 4.0 / 3 * 3.14159265, 1e-4);
  std::mt19937 random(5);
  for (int round = 0; round < 10; ++round)
  {
    std::shuffle(surface.triangles.begin(), surface.triangles.end(), random);
    for (winding::Triangle& triangle : surface.triangles)
    {
      std::rotate(triangle.begin(), triangle.begin() + random() % 3, triangle.end());
    }
    EXPECT_EQ(winding::volumeOf(surface), volume);
  }
}

TEST(SourceVolume, IsAboutThatOfClouds)
{
  PointCloud cloud;
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i)
  {
    const Point direction = Point(normal(random), normal(random), normal(random)).normalized();
    cloud.positions.push_back(2 * direction + Point(5, 0, 0));
    cloud.normals.push_back(direction);
    cloud.areas.push_back(16 * 3.14159265 / count);
    cloud.bounds.extend(cloud.positions.back());
  }
  // Measured: 33.52.
  EXPECT_NEAR(winding::volumeOf(cloud), 32.0 / 3 * 3.14159265, 0.1);
}

} // namespace
