// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "distance/PrimitivesNear.h"

#include "support/NaiveDistance.h"
#include "support/Samples.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace shapes;

TEST(PrimitivesNear, AreThoseThatTheDefinitionFinds)
{
  SCOPED_TRACE("seeds 816, 817");
  const Mesh mesh = triangleSoup(200, 816);
  const Cloud cloud = randomCloud(200, 816);
  const winding::Surface surface = clean(mesh);
  const winding::PointCloud points = clean(cloud);
  std::size_t most = 0;
  for (const Point& sample : randomPoints(300, -2, 2, 817))
  {
    for (const double distance : {0.0, 0.03, 0.4, 3.0})
    {
      std::size_t triangles = 0, ofCloud = 0;
      for (const auto& t : mesh.triangles)
      {
        const auto corner = [&](std::size_t i)
        {
          return mesh.points[static_cast<std::size_t>(t[i])];
        };
        triangles += naiveDistance(sample, corner(0), corner(1), corner(2)) <= distance;
      }
      for (const Point& point : cloud.positions)
      {
        ofCloud += (sample - point).norm() <= distance;
      }
      ASSERT_EQ(winding::trianglesNear(surface, sample, distance), triangles);
      ASSERT_EQ(winding::pointsNear(points, sample, distance), ofCloud);
      most = std::max(most, triangles);
    }
  }
  EXPECT_EQ(most, 200u);
  // Vertices and points themselves are at no distance, however far from the origin and small.
  for (const double size : {1e-100, 1.0, 5e99})
  {
    const Mesh scaled = cube({1, 1, 1}, {2, 2, 2}).scaled(size);
    EXPECT_GE(winding::trianglesNear(clean(scaled), scaled.points[0], 0), 3u);
    EXPECT_EQ(winding::trianglesNear(clean(scaled), 1.5 * scaled.points[0], 0.4 * size), 0u);
    EXPECT_EQ(winding::trianglesNear(clean(scaled), 1.5 * scaled.points[0], 0.6 * size), 12u);
  }
}
