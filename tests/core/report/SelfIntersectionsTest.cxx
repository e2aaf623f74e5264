// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/SelfIntersections.h"

#include "support/Serial.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

using namespace shapes;

std::size_t countOf(const Mesh& mesh)
{
  const winding::TriangleList triangles(mesh.triangles.begin(), mesh.triangles.end());
  ShuffledThreads threads(1);
  const std::size_t count = winding::countSelfIntersections(mesh.points, triangles, serial);
  EXPECT_EQ(count, winding::countSelfIntersections(mesh.points, triangles, threads));
  return count;
}

Mesh movedBy(const Mesh& mesh, const Point& offset)
{
  return mesh.moved(offset);
}

} // namespace

TEST(SelfIntersections, OfClosedShapesAreNone)
{
  EXPECT_EQ(countOf(Mesh()), 0u);
  EXPECT_EQ(countOf(cube()), 0u);
  EXPECT_EQ(countOf(icosphere(3)), 0u);
  EXPECT_EQ(countOf(torus(40, 20)), 0u);
  EXPECT_EQ(countOf(surfaceOf(randomCells(4, 3))), 0u) << "coplanar faces do not count";
}

TEST(SelfIntersections, OfTwoTetrahedraAreThePairsOfTrianglesThatCross)
{
  // One corner sticks through a face: three triangles through one.
  const Mesh small = tetrahedron().scaled(0.01);
  Mesh wall;
  wall.points = {{-1, -1, 0.003}, {1, -1, 0.0031}, {0, 2, 0.0032}};
  wall.triangles = {{0, 1, 2}};
  const std::size_t through = countOf(small.with(wall));
  EXPECT_TRUE(through == 3 || through == 4) << through;
  EXPECT_EQ(countOf(small.with(movedBy(wall, {0, 0, 5}))), 0u);
}

TEST(SelfIntersections, AreFoundWhicheverOfTwoTrianglesWithACommonVertexGoesThroughTheOther)
{
  // The last edge of the second triangle goes through the first one.
  const Mesh two{
    {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1.1, 1}}, {{0, 1, 2}, {0, 3, 4}}};
  Mesh apart = two;
  apart.points[3][2] = 0.5;
  for (int turn = 0; turn < 18; ++turn)
  {
    const auto turnedBy = [turn](Mesh mesh)
    {
      const auto rotate = [](auto& ids, int by)
      {
        std::rotate(ids.begin(), ids.begin() + by, ids.end());
      };
      rotate(mesh.triangles[0], turn % 3);
      rotate(mesh.triangles[1], turn / 3 % 3);
      if (turn >= 9)
      {
        std::swap(mesh.triangles[0], mesh.triangles[1]);
      }
      return mesh;
    };
    EXPECT_EQ(countOf(turnedBy(two)), 1u) << turn;
    EXPECT_EQ(countOf(turnedBy(apart)), 0u) << turn;
  }
}

TEST(SelfIntersections, AreThoseThatAllPairsShow)
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    const Mesh soup = triangleSoup(200, seed);
    std::size_t pairs = 0;
    for (std::size_t a = 0; a < soup.triangles.size(); ++a)
    {
      for (std::size_t b = 0; b < a; ++b)
      {
        const winding::TriangleList two = {soup.triangles[a], soup.triangles[b]};
        pairs += winding::countSelfIntersections(soup.points, two, serial);
      }
    }
    EXPECT_EQ(countOf(soup), pairs) << seed;
    EXPECT_GT(pairs, 0u);
  }
}

TEST(SelfIntersections, OfTwoSpheresLieAlongTheirCommonCircle)
{
  const Mesh ball = icosphere(3);
  const std::size_t apart = countOf(ball.with(movedBy(ball, {2.5, 0, 0})));
  EXPECT_EQ(apart, 0u);
  const std::size_t crossing = countOf(ball.with(movedBy(ball, {1.03, 0.02, 0.01})));
  EXPECT_GT(crossing, 100u); // measured: about 200
  EXPECT_LT(crossing, 600u);
}
