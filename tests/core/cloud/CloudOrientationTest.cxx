// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/CloudOrientation.h"

#include "cloud/PointAreas.h"
#include "source/PointCloud.h"
#include "support/Places.h"
#include "support/Samples.h"
#include "support/Serial.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

namespace
{

using namespace shapes;

winding::PointCloud withAreas(const Cloud& cloud)
{
  winding::PointCloud result = clean(cloud);
  result.areas =
    winding::voronoiAreas(result, placesOf(result.positions), winding::defaultNeighbors, serial);
  return result;
}

winding::CloudOrientation orientationOf(const Cloud& cloud)
{
  return winding::orientationOf(withAreas(cloud), serial);
}

Cloud reversed(Cloud cloud)
{
  for (Point& normal : cloud.normals)
  {
    normal = -normal;
  }
  return cloud;
}

} // namespace

TEST(CloudOrientation, OfASphereIsOutwardAndOfItsReverseInward)
{
  const winding::CloudOrientation outward = orientationOf(sphereCloud(5000));
  EXPECT_EQ(outward.outward, 1);
  EXPECT_EQ(outward.inward, 0);
  EXPECT_NEAR(outward.behind, 1, 0.02);
  EXPECT_NEAR(outward.before, 0, 0.02);
  EXPECT_TRUE(outward.isClear());
  EXPECT_FALSE(outward.isInward());

  const winding::CloudOrientation inward = orientationOf(reversed(sphereCloud(5000)));
  EXPECT_EQ(inward.inward, 1);
  EXPECT_TRUE(inward.isInward());
  EXPECT_TRUE(inward.isClear());
  EXPECT_NEAR(inward.before, -1, 0.02);
  EXPECT_TRUE(inward.isMostlyInward());
  const winding::CloudOrientation unclear = {0, 0, 0.2, 0.4};
  EXPECT_TRUE(unclear.isInward()) << "estimated normals are better turned";
  EXPECT_FALSE(unclear.isMostlyInward());
  const winding::CloudOrientation back = inward.reversed();
  EXPECT_EQ(back.outward, 1);
  EXPECT_EQ(back.before, -inward.behind);
  EXPECT_EQ(back.behind, -inward.before);
}

TEST(CloudOrientation, TakesWindingNumbersLessThanAQuarterOffForClear)
{
  for (const double factor : {0.72, 0.78, 1.22, 1.28})
  {
    // w is the factor behind the points, and 0 before them.
    winding::PointCloud cloud = withAreas(sphereCloud(5000));
    for (double& area : cloud.areas)
    {
      area *= factor;
    }
    const winding::CloudOrientation found = winding::orientationOf(cloud, serial);
    EXPECT_NEAR(found.behind, factor, 0.01);
    EXPECT_EQ(found.outward, std::abs(factor - 1) < 0.25 ? 1 : 0) << factor;
  }
}

TEST(CloudOrientation, IsNotClearWhereNormalsContradictEachOther)
{
  SCOPED_TRACE("seed 96");
  Cloud cloud = sphereCloud(5000);
  Random random(96);
  for (Point& normal : cloud.normals)
  {
    normal *= random(0, 1) < 0.3 ? -1 : 1;
  }
  const winding::CloudOrientation orientation = orientationOf(cloud);
  record("outward", orientation.outward);
  EXPECT_FALSE(orientation.isClear());
  EXPECT_LT(orientation.outward, 0.2);
}

TEST(CloudOrientation, OfAnOpenSheetIsNotClear)
{
  Cloud sheet;
  for (int i = 0; i < 2500; ++i)
  {
    sheet.positions.emplace_back(i % 50, i / 50, 0);
    sheet.normals.emplace_back(0, 0, 1);
  }
  const winding::CloudOrientation orientation = orientationOf(sheet);
  EXPECT_FALSE(orientation.isClear());
  EXPECT_NEAR(orientation.behind, 0.5, 0.1);
  EXPECT_NEAR(orientation.before, -0.5, 0.1);
}

TEST(CloudOrientation, IsNotFooledByThousandsOfEqualPoints)
{
  Cloud cloud = sphereCloud(3000);
  cloud.positions.insert(cloud.positions.end(), 50'000, cloud.positions[0]);
  cloud.normals.insert(cloud.normals.end(), 50'000, cloud.normals[0]);
  EXPECT_GT(orientationOf(cloud).outward, 0.99);
}

TEST(CloudOrientation, OfNothingIsNothing)
{
  EXPECT_FALSE(winding::orientationOf(winding::PointCloud(), serial).isClear());
  // A single point has an area of 0.
  EXPECT_FALSE(orientationOf(Cloud{{{1, 2, 3}}, {{0, 0, 1}}}).isClear());
}

TEST(CloudOrientation, DoesNotDependOnTheThreads)
{
  SCOPED_TRACE("seed 97");
  ShuffledThreads threads(97);
  const winding::PointCloud cloud = withAreas(sphereCloud(3000));
  const winding::CloudOrientation one = winding::orientationOf(cloud, serial);
  const winding::CloudOrientation many = winding::orientationOf(cloud, threads);
  EXPECT_EQ(one.behind, many.behind);
  EXPECT_EQ(one.before, many.before);
  EXPECT_EQ(one.outward, many.outward);
}
