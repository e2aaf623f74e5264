// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "source/MeshVertices.h"

#include "support/Serial.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace
{

using namespace shapes;
using winding::MeshVertices;

MeshVertices verticesOf(const std::vector<winding::TrianglesView>& views, std::size_t points)
{
  return winding::meshVertices(views, points, serial);
}

MeshVertices verticesOf(const Mesh& mesh)
{
  return verticesOf({mesh.view()}, mesh.points.size());
}

Point normalOf(const MeshVertices& vertices, std::size_t point)
{
  return vertices.normals()[point];
}

std::vector<double> areasOf(const MeshVertices& vertices)
{
  std::vector<double> areas(vertices.areas().size());
  for (std::size_t point = 0; point < areas.size(); ++point)
  {
    areas[point] = vertices.areas()[point];
  }
  return areas;
}

/// Compares normals and areas of the points that `expected` has.
void expectEqual(const MeshVertices& found, const MeshVertices& expected)
{
  ASSERT_GE(found.areas().size(), expected.areas().size());
  for (std::size_t point = 0; point < expected.areas().size(); ++point)
  {
    EXPECT_EQ(normalOf(found, point), normalOf(expected, point)) << point;
    EXPECT_EQ(found.areas()[point], expected.areas()[point]) << point;
  }
}

double areaOf(const Mesh& mesh)
{
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    area += (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]).norm() / 2;
  }
  return area;
}

} // namespace

TEST(MeshVertices, HaveTheSumsOverTheirTriangles)
{
  for (unsigned seed = 1101; seed < 1106; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    // The triangles are loose except that their first corners are made to meet.
    Mesh mesh = triangleSoup(300, seed);
    Random random(seed);
    for (auto& triangle : mesh.triangles)
    {
      triangle[0] = static_cast<std::int32_t>(random.bits() % 50);
    }
    const MeshVertices found = verticesOf(mesh);
    ASSERT_EQ(found.areas().size(), mesh.points.size());
    ASSERT_EQ(found.normals().size(), mesh.points.size());
    for (std::size_t point = 0; point < mesh.points.size(); ++point)
    {
      Point normal(0, 0, 0);
      double area = 0;
      for (const auto& [a, b, c] : mesh.triangles)
      {
        const Point areaVector =
          (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]) / 2;
        for (const std::int32_t corner : {a, b, c})
        {
          if (static_cast<std::size_t>(corner) == point)
          {
            normal += areaVector;
            area += areaVector.norm() / 3;
          }
        }
      }
      EXPECT_NEAR((normalOf(found, point) - normal).norm(), 0, 1e-12);
      EXPECT_NEAR(found.areas()[point], area, 1e-12);
    }
  }
}

TEST(MeshVertices, TogetherHaveTheAreaOfTheMesh)
{
  for (const Mesh& mesh : {icosphere(3), openCube(), torus(20, 10), triangleSoup(1000, 1111)})
  {
    const MeshVertices found = verticesOf(mesh);
    const std::vector<double> areas = areasOf(found);
    const double total = std::accumulate(areas.begin(), areas.end(), 0.0);
    EXPECT_NEAR(total, areaOf(mesh), 1e-12 * areaOf(mesh));
  }
}

TEST(MeshVertices, OfASphereLookOutward)
{
  const Mesh sphere = icosphere(3);
  const MeshVertices found = verticesOf(sphere);
  for (std::size_t point = 0; point < sphere.points.size(); ++point)
  {
    // Measured: 0.99996 at least.
    EXPECT_GT(normalOf(found, point).normalized().dot(sphere.points[point]), 0.999);
  }
}

TEST(MeshVertices, WithoutTrianglesAreZero)
{
  Mesh mesh = cube();
  mesh.points.emplace_back(5, 5, 5);
  const MeshVertices found = verticesOf(mesh);
  EXPECT_EQ(normalOf(found, 8), Point(0, 0, 0));
  EXPECT_EQ(found.areas()[8], 0);
  EXPECT_TRUE(verticesOf({}, 0).areas().empty());
  EXPECT_EQ(areasOf(verticesOf({}, 3)), std::vector<double>(3));
}

TEST(MeshVertices, LeaveBadTrianglesOut)
{
  const MeshVertices expected = verticesOf(cube());
  Mesh mesh = cube();
  mesh.triangles.push_back({0, 1, 8});
  mesh.triangles.push_back({0, 1, -1});
  expectEqual(verticesOf(mesh), expected);
  mesh.points.emplace_back(0, std::numeric_limits<double>::infinity(), 0); // point number 8
  expectEqual(verticesOf(mesh), expected);
}

TEST(MeshVertices, OfSeveralViewsOverTheSamePointsAddUp)
{
  const Mesh mesh = icosphere(2);
  const Mesh first = mesh.part(0, 100), second = mesh.part(100, mesh.triangles.size());
  const MeshVertices expected = verticesOf(mesh);
  const MeshVertices found = verticesOf({first.view(), second.view()}, mesh.points.size());
  expectEqual(found, expected);
}

TEST(MeshVertices, OfManyTrianglesAreTheSumsOfTwoParts)
{
  // 81 920 triangles, of which each point has some in both halves when every other one comes last.
  Mesh mesh = icosphere(6);
  std::stable_partition(mesh.triangles.begin(), mesh.triangles.end(),
    [i = 0](const auto&) mutable { return i++ % 2 == 0; });
  ShuffledThreads threads(91);
  const MeshVertices found = winding::meshVertices({mesh.view()}, mesh.points.size(), threads);
  std::reverse(mesh.triangles.begin(), mesh.triangles.end());
  const MeshVertices reversed = verticesOf(mesh);
  expectEqual(found, reversed);
  std::vector<double> areas(mesh.points.size());
  for (const auto& t : mesh.triangles)
  {
    const Point a = mesh.points[static_cast<std::size_t>(t[0])];
    const Point u = mesh.points[static_cast<std::size_t>(t[1])] - a;
    const Point v = mesh.points[static_cast<std::size_t>(t[2])] - a;
    for (const auto id : t)
    {
      areas[static_cast<std::size_t>(id)] += u.cross(v).norm() / 6;
    }
  }
  for (std::size_t i = 0; i < areas.size(); ++i)
  {
    ASSERT_NEAR(found.areas()[i], areas[i], 1e-13 * areas[i]); // measured: 8e-16
  }
}
