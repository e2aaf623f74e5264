// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/Slits.h"

#include "source/Surface.h"
#include "support/Serial.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <random>

namespace
{

using namespace shapes;
using winding::Slits;
using winding::Surface;
using winding::SurfaceEdges;

struct Measured
{
  Surface surface;
  SurfaceEdges edges;
  Slits slits;
};

Measured measured(const Mesh& mesh)
{
  Measured result;
  result.surface = clean(mesh);
  result.edges = winding::edgesOf(result.surface, serial);
  result.slits = winding::slitsOf(result.surface, result.edges, serial);
  EXPECT_EQ(result.slits.widths.size(), result.edges.rims.size());
  EXPECT_EQ(result.slits.endDistances.size(), result.edges.rims.size());
  return result;
}

double widestOf(const Mesh& mesh)
{
  return measured(mesh).slits.widest().value();
}

using Ends = std::pair<Point, Point>;

/// The ends of a boundary edge in the order in which its triangle has them.
Ends endsOf(const Measured& of, const SurfaceEdges::Rim& rim)
{
  const winding::Triangle& t = of.surface.triangles[rim.triangle];
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (t[i] == rim.low && t[(i + 1) % 3] == rim.high)
    {
      return {of.surface.vertices[rim.low], of.surface.vertices[rim.high]};
    }
  }
  return {of.surface.vertices[rim.high], of.surface.vertices[rim.low]};
}

double distance(const Ends& edge, const Point& point)
{
  const Point along = edge.second - edge.first;
  const double share = (point - edge.first).dot(along) / along.squaredNorm();
  return (edge.first + std::clamp(share, 0.0, 1.0) * along - point).norm();
}

/// Compares all widths with the least of all distances.
void expectByDefinition(const Mesh& mesh)
{
  const Measured found = measured(mesh);
  std::vector<Ends> all;
  for (const SurfaceEdges::Rim& rim : found.edges.rims)
  {
    all.push_back(endsOf(found, rim));
  }
  const double diagonal = found.surface.bounds.isEmpty() ? 0 : found.surface.bounds.sizes().norm();
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const auto& [from, to] = all[i];
    double expected = 0;
    for (const Point& point : {from, Point((from + to) / 2), to})
    {
      double least = diagonal;
      for (const Ends& other : all)
      {
        const Point p = other.second - other.first, q = to - from;
        const double product = (p[0] * q[0] + p[1] * q[1]) + p[2] * q[2];
        least = product < 0 ? std::min(least, distance(other, point)) : least;
      }
      expected = std::max(expected, least);
    }
    ASSERT_NEAR(found.slits.widths[i], expected, 1e-14 * diagonal) << "edge " << i;
  }
}

/// A sphere whose upper and lower half have points of their own, `width` apart.
Mesh sphereWithSeam(double width)
{
  const Mesh sphere = icosphere(3);
  Mesh upper{sphere.points, {}}, lower{sphere.points, {}};
  for (const auto& t : sphere.triangles)
  {
    const double height = (sphere.points[t[0]] + sphere.points[t[1]] + sphere.points[t[2]])[2];
    (height > 0 ? upper : lower).triangles.push_back(t);
  }
  return lower.with(upper.moved({width, 0, 0}));
}

/// The unit cube, one of whose sides has a point in the middle of an edge, moved out by `width`,
/// that the side next to it does not have.
Mesh cubeWithPointOnEdge(double width)
{
  Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1},
              {1 + width, 0.5, 1}},
    {{0, 2, 1}, {1, 2, 3}, {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6},
      {1, 3, 5}, {3, 7, 5}, {4, 5, 8}, {4, 8, 6}, {8, 7, 6}}};
  return mesh;
}

/// Triangles between few points at random.
Mesh tangle(unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_int_distribution<std::int32_t> pick(0, 11);
  Mesh mesh;
  for (int i = 0; i < 12; ++i)
  {
    mesh.points.emplace_back(pick(random), pick(random), pick(random));
  }
  for (int i = 0; i < 14; ++i)
  {
    mesh.triangles.push_back({pick(random), pick(random), pick(random)});
  }
  return mesh;
}

} // namespace

TEST(Slits, OfAClosedSurfaceAreNone)
{
  EXPECT_FALSE(measured(cube()).slits.widest());
  EXPECT_FALSE(measured(Mesh()).slits.widest());
}

TEST(Slits, AreAboutAsWideAsHoles)
{
  EXPECT_EQ(measured(openCube()).slits.widths, std::vector<double>(4, 1.0));
  // Edges that meet at 60° run opposite ways, so that ends have 0 and the middle a quarter of √3.
  Mesh sphere{{{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}, {0.5, 0.3, 1}},
    {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  EXPECT_NEAR(widestOf(sphere), std::sqrt(3.0) / 4, 1e-15);
}

TEST(Slits, AreAsWideAsTheyWereMade)
{
  for (const double width : {1e-3, 1e-9, 1e-15})
  {
    const Measured found = measured(sphereWithSeam(width));
    EXPECT_EQ(found.edges.rims.size() % 2, 0u);
    // Coordinates up to 1 are rounded to 1.1e-16.
    EXPECT_NEAR(found.slits.widest().value(), width, 3e-16) << width;
    const auto& distances = found.slits.endDistances;
    EXPECT_NEAR(*std::max_element(distances.begin(), distances.end()), width, 3e-16) << width;
  }
}

TEST(Slits, AtPointsOnEdgesOfOthersHaveFarEnds)
{
  const Measured found = measured(cubeWithPointOnEdge(1e-12));
  EXPECT_EQ(found.edges.rims.size(), 3u);
  EXPECT_NEAR(found.slits.widest().value(), 1e-12, 3e-16);
  const auto& distances = found.slits.endDistances;
  EXPECT_NEAR(*std::min_element(distances.begin(), distances.end()), 0.5, 1e-9);
}

TEST(Slits, BesideATriangleThatIsTurnedAreOpen)
{
  Mesh seam = sphereWithSeam(1e-9);
  const Measured before = measured(seam);
  const auto turned = static_cast<std::size_t>(before.edges.rims[0].triangle);
  std::swap(seam.triangles[turned][0], seam.triangles[turned][1]);
  EXPECT_LT(before.slits.widest().value(), 2e-9);
  EXPECT_GT(widestOf(seam), 0.01);
}

TEST(Slits, HaveTheWidthsOfTheirDefinition)
{
  for (unsigned seed = 1; seed <= 40; ++seed)
  {
    SCOPED_TRACE(seed);
    ASSERT_NO_FATAL_FAILURE(expectByDefinition(tangle(seed)));
    ASSERT_NO_FATAL_FAILURE(expectByDefinition(triangleSoup(60, seed)));
  }
  Mesh holes = icosphere(4);
  std::mt19937 random(3);
  std::shuffle(holes.triangles.begin(), holes.triangles.end(), random);
  holes.triangles.resize(4000);
  ASSERT_NO_FATAL_FAILURE(expectByDefinition(holes));
  ASSERT_NO_FATAL_FAILURE(expectByDefinition(sphereWithSeam(1e-5)));
}

TEST(Slits, HaveTheSameBitsForAnyThreadsOrderAndPowerOfTwo)
{
  using Values = std::map<std::array<double, 6>, std::pair<double, double>>;
  const auto valuesOf = [](const Measured& of, double scale)
  {
    Values values;
    for (std::size_t i = 0; i < of.edges.rims.size(); ++i)
    {
      const Point a = of.surface.vertices[of.edges.rims[i].low] / scale,
                  b = of.surface.vertices[of.edges.rims[i].high] / scale;
      std::array<double, 6> key = {a[0], a[1], a[2], b[0], b[1], b[2]};
      const std::array<double, 6> other = {b[0], b[1], b[2], a[0], a[1], a[2]};
      values[std::min(key, other)] = {of.slits.widths[i] / scale, of.slits.endDistances[i] / scale};
    }
    return values;
  };
  Mesh mesh = sphereWithSeam(1e-9).with(triangleSoup(5000, 7));
  const Measured first = measured(mesh);
  const Values expected = valuesOf(first, 1);
  ASSERT_GT(expected.size(), 15'000u);
  ShuffledThreads threads(31);
  const Slits again = winding::slitsOf(first.surface, first.edges, threads);
  EXPECT_EQ(again.widths, first.slits.widths);
  EXPECT_EQ(again.endDistances, first.slits.endDistances);
  std::mt19937 random(5);
  std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
  for (auto& triangle : mesh.triangles)
  {
    std::rotate(triangle.begin(), triangle.begin() + random() % 3, triangle.end());
  }
  EXPECT_TRUE(valuesOf(measured(mesh), 1) == expected);
  const double scale = std::ldexp(1, 40);
  EXPECT_TRUE(valuesOf(measured(mesh.scaled(scale)), scale) == expected);
}

TEST(Slits, OfALoopAreOfItsEdges)
{
  const Measured found = measured(openCube().with(sphereWithSeam(1e-9).moved({5, 0, 0})));
  const winding::BoundaryChain chain = boundaryOf(found.surface);
  const auto loops = winding::boundaryLoops(chain.edges, found.surface.vertices.size(), serial);
  ASSERT_EQ(loops.size(), 3u);
  std::vector<double> widths;
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    widths.push_back(winding::widestAlong(loops[i], found.edges, found.slits).value());
  }
  std::sort(widths.begin(), widths.end());
  EXPECT_NEAR(widths[0], 1e-9, 1e-14);
  EXPECT_NEAR(widths[1], 1e-9, 1e-14);
  EXPECT_EQ(widths[2], 1);
  // A loop along edges of two triangles that disagree has no boundary edges.
  Mesh turned = cube();
  std::swap(turned.triangles[3][0], turned.triangles[3][1]);
  const Measured none = measured(turned);
  const auto others =
    winding::boundaryLoops(boundaryOf(none.surface).edges, none.surface.vertices.size(), serial);
  ASSERT_FALSE(others.empty());
  EXPECT_FALSE(winding::widestAlong(others[0], none.edges, none.slits));
}

TEST(MedianEdgeLength, IsTheMiddleOfAllLengths)
{
  const auto median = [](const Mesh& mesh)
  {
    const Surface surface = clean(mesh);
    return winding::medianEdgeLength(surface, winding::edgesOf(surface, serial), serial);
  };
  EXPECT_EQ(median(Mesh()), 0);
  EXPECT_EQ(median(cube()), 1); // twelve edges, and six diagonals
  EXPECT_EQ(median(cube({0, 0, 0}, {1e-90, 1e-90, 1e-90})), 1e-90);
}
