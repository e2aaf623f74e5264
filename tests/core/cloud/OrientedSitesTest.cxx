// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/OrientedSites.h"

#include "source/CompareCoordinates.h"
#include "source/PointCloud.h"
#include "support/Serial.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace
{

using namespace shapes;
using winding::areSimilar;
using winding::DistinctPoints;
using winding::OrientedSites;

/// A cloud with random normals, many of them at each of a few places.
winding::PointCloud crowdedCloud(std::size_t count, std::size_t places, unsigned seed)
{
  const std::vector<Point> at = randomPoints(places, -1, 1, seed);
  Random random(seed);
  winding::PointCloud cloud;
  for (std::size_t i = 0; i < count; ++i)
  {
    cloud.positions.push_back(at[random.bits() % places]);
    cloud.normals.push_back(random.direction());
  }
  return cloud;
}

} // namespace

TEST(OrientedSites, AreSimilarWithin70Degrees)
{
  const double degree = std::acos(-1.0) / 180;
  const auto turned = [degree](double degrees)
  {
    return Point(std::sin(degrees * degree), 0, std::cos(degrees * degree));
  };
  EXPECT_TRUE(areSimilar(turned(0), turned(0)));
  EXPECT_TRUE(areSimilar(turned(10), turned(79.99)));
  EXPECT_FALSE(areSimilar(turned(10), turned(80.01)));
  EXPECT_FALSE(areSimilar(turned(0), turned(180)));
}

TEST(OrientedSites, GroupThePointsOfEachPlaceByTheirFirst)
{
  for (unsigned seed = 1001; seed < 1011; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const winding::PointCloud cloud = crowdedCloud(3000, 1 + 30 * (seed - 1001), seed);
    const DistinctPoints places(cloud.positions, 1, serial);
    const OrientedSites sites(cloud, places, serial);
    std::size_t next = 0;
    for (std::size_t place = 0; place < places.size(); ++place)
    {
      // By definition a point joins the first site whose first point is similar, or begins one; the
      // points come in the order of their normals.
      std::vector<std::uint32_t> points(places.begin(place), places.end(place));
      std::sort(points.begin(), points.end(),
        [&cloud](std::uint32_t a, std::uint32_t b)
        { return winding::compareCoordinates(cloud.normals[a], cloud.normals[b]) < 0; });
      std::vector<Point> firsts, sums;
      std::vector<std::uint32_t> counts;
      EXPECT_EQ(sites.begin(place), next);
      for (const std::uint32_t point : points)
      {
        const Point& normal = cloud.normals[point];
        const auto found = std::find_if(firsts.begin(), firsts.end(),
          [&normal](const Point& first) { return areSimilar(first, normal); });
        const auto site = static_cast<std::size_t>(found - firsts.begin());
        if (site == firsts.size())
        {
          firsts.push_back(normal);
          sums.emplace_back(0, 0, 0);
          counts.push_back(0);
        }
        sums[site] += normal;
        ++counts[site];
        EXPECT_EQ(sites.siteOf(point), sites.begin(place) + site);
      }
      ASSERT_EQ(sites.end(place) - sites.begin(place), firsts.size());
      EXPECT_LE(firsts.size(), 9u);
      for (std::size_t i = 0; i < firsts.size(); ++i)
      {
        const winding::OrientedSite& site = sites[sites.begin(place) + i];
        EXPECT_EQ(site.points, counts[i]);
        EXPECT_NEAR((site.normal - sums[i].normalized()).norm(), 0, 1e-15);
        EXPECT_NEAR(site.normal.norm(), 1, 1e-15);
        EXPECT_TRUE(sites.hasSimilar(place, site.normal));
      }
      next = sites.end(place);
    }
    EXPECT_EQ(sites.size(), next);
  }
}

TEST(OrientedSites, HaveSimilarNormalsOrNot)
{
  winding::PointCloud cloud;
  cloud.positions.assign(2, Point(1, 2, 3));
  cloud.normals = {Point(0, 0, 1), Point(0, 0, -1)};
  const DistinctPoints places(cloud.positions, 1, serial);
  const OrientedSites sites(cloud, places, serial);
  EXPECT_EQ(sites.size(), 2u) << "two sides";
  EXPECT_TRUE(sites.hasSimilar(0, Point(0, 0.1, 1).normalized()));
  EXPECT_TRUE(sites.hasSimilar(0, Point(0, 0.1, -1).normalized()));
  EXPECT_FALSE(sites.hasSimilar(0, Point(1, 0, 0)));
}

TEST(OrientedSites, AreTheSameForAnyExecutor)
{
  SCOPED_TRACE("seed 1021");
  const winding::PointCloud cloud = crowdedCloud(50'000, 15'000, 1021);
  ShuffledThreads threads(1022);
  const DistinctPoints places(cloud.positions, 1, serial);
  const OrientedSites one(cloud, places, serial), other(cloud, places, threads);
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t site = 0; site < one.size(); ++site)
  {
    EXPECT_EQ(one[site].normal, other[site].normal);
    EXPECT_EQ(one[site].points, other[site].points);
  }
  for (std::size_t point = 0; point < cloud.positions.size(); ++point)
  {
    EXPECT_EQ(one.siteOf(point), other.siteOf(point));
  }
}
