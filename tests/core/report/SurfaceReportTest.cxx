// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/SurfaceReport.h"
#include "base/Pi.h"

#include "source/Sanitize.h"
#include "source/Surface.h"
#include "support/Serial.h"
#include "support/Shapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace shapes;
using winding::EdgeCounts;
using winding::SurfaceReport;

SurfaceReport report(const Mesh& mesh)
{
  const winding::Surface surface = clean(mesh);
  return winding::reportOn(surface, winding::edgesOf(surface, serial), serial);
}

struct Expected
{
  std::size_t edges, boundary, netBoundary, nonManifold, inconsistent, boundaryLoops, components;
};

void expectEdges(const Mesh& mesh, const Expected& expected)
{
  const EdgeCounts counts = report(mesh).edges;
  EXPECT_EQ(counts.edges, expected.edges);
  EXPECT_EQ(counts.boundary, expected.boundary);
  EXPECT_EQ(counts.netBoundary, expected.netBoundary);
  EXPECT_EQ(counts.nonManifold, expected.nonManifold);
  EXPECT_EQ(counts.inconsistent, expected.inconsistent);
  EXPECT_EQ(counts.boundaryLoops, expected.boundaryLoops);
  EXPECT_EQ(counts.components, expected.components);
  EXPECT_EQ(counts.isClosed(), expected.netBoundary == 0);
}

} // namespace

TEST(CountEdges, FindsClosedShapesClosed)
{
  expectEdges(cube(), {18, 0, 0, 0, 0, 0, 1});
  expectEdges(tetrahedron(), {6, 0, 0, 0, 0, 0, 1});
  expectEdges(torus(12, 8), {288, 0, 0, 0, 0, 0, 1});
  expectEdges(Mesh(), {0, 0, 0, 0, 0, 0, 0});
}

TEST(CountEdges, FindsTheRimOfAnOpenCube)
{
  expectEdges(openCube(), {17, 4, 4, 0, 0, 1, 1});
}

TEST(CountEdges, FindsEveryHoleOnce)
{
  Mesh mesh = icosphere(2);
  // The holes are far apart: they are children of different faces of the icosahedron.
  for (const std::size_t hole : {300, 150, 0})
  {
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(hole));
  }
  expectEdges(mesh, {480, 9, 9, 0, 0, 3, 1});
}

TEST(CountEdges, FindsTheOneRimAndTheTwistOfAMoebiusStrip)
{
  // The edge where the ends meet is used twice in the same direction.
  expectEdges(moebiusStrip(10), {40, 20, 21, 0, 1, 1, 1});
}

TEST(CountEdges, TellsTwoCubesApart)
{
  expectEdges(cube().with(cube({2, 0, 0}, {3, 1, 1})), {36, 0, 0, 0, 0, 0, 2});
}

TEST(CountEdges, ConnectsThroughEdgesAndNotThroughVertices)
{
  const Mesh corner = cube().with(cube({1, 1, 1}, {2, 2, 2}));
  expectEdges(corner, {36, 0, 0, 0, 0, 0, 2});
  EXPECT_EQ(report(corner).vertexComponents, 1u);
  // Two cubes share an edge, where four triangles meet.
  expectEdges(surfaceOf({{0, 0, 0}, {1, 1, 0}}), {35, 0, 0, 1, 0, 0, 1});
}

TEST(CountEdges, CountsTheUsesOfTheBackOfABook)
{
  expectEdges(book(3, false), {7, 6, 7, 1, 0, 1, 1});
  expectEdges(book(4, true), {9, 8, 8, 1, 0, 1, 1});
}

TEST(CountEdges, FindsAFlippedTriangle)
{
  Mesh mesh = cube();
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  expectEdges(mesh, {18, 0, 3, 0, 3, 0, 1});
  expectEdges(cube().reversed(), {18, 0, 0, 0, 0, 0, 1});
}

TEST(SurfaceReport, HasTheAreaVolumeAndEulerCharacteristicOfTheCube)
{
  const SurfaceReport cubes = report(cube());
  EXPECT_DOUBLE_EQ(cubes.area, 6);
  EXPECT_DOUBLE_EQ(cubes.volume, 1);
  EXPECT_EQ(cubes.eulerCharacteristic, 2);
  EXPECT_EQ(cubes.duplicateTriangles, 0u);
  EXPECT_EQ(cubes.zeroAreaTriangles, 0u);
  EXPECT_DOUBLE_EQ(report(cube().reversed()).volume, -1);
  EXPECT_EQ(report(torus(12, 8)).eulerCharacteristic, 0);
  EXPECT_EQ(report(cube().with(cube({2, 0, 0}, {3, 1, 1}))).eulerCharacteristic, 4);
}

TEST(SurfaceReport, ComesCloseToTheAreaAndVolumeOfTheSphere)
{
  const SurfaceReport sphere = report(icosphere(4));
  // The mesh is inscribed, with edges of 0.07: it lacks about edge²/4 of the volume. The relative
  // errors were measured as 0.0032 and 0.0016.
  EXPECT_NEAR(sphere.volume, 4 * winding::pi / 3, 0.02);
  EXPECT_NEAR(sphere.area, 4 * winding::pi, 0.03);
}

TEST(SurfaceReport, HasTheWidestSlitOfABoundary)
{
  EXPECT_FALSE(report(cube()).widestSlit);
  EXPECT_FALSE(report(cube()).isClosedExceptForSlits());
  EXPECT_EQ(report(openCube()).widestSlit, 1);
  EXPECT_FALSE(report(openCube()).isClosedExceptForSlits());
  const Mesh slit = cubeWithSlit(1e-12);
  EXPECT_NEAR(report(slit).widestSlit.value(), 1e-12, 3e-16);
  EXPECT_EQ(report(slit).medianEdgeLength, 1);
  EXPECT_TRUE(report(slit).isClosedExceptForSlits());
  EXPECT_TRUE(report(slit).canBeWelded());
  EXPECT_FALSE(report(cubeWithSlit(0.01)).isClosedExceptForSlits());
  EXPECT_FALSE(report(slit.with(openCube())).isClosedExceptForSlits());
  Mesh turned = slit.with(cube({2, 0, 0}, {3, 1, 1}));
  std::swap(turned.triangles.back()[0], turned.triangles.back()[1]);
  EXPECT_FALSE(report(turned).isClosedExceptForSlits()) << "edges disagree";
  EXPECT_FALSE(report(slit.with(book(3, false))).isClosedExceptForSlits());
}

TEST(SurfaceReport, KnowsSlitsThatWeldingDoesNotClose)
{
  // One side has a point in the middle of an edge of the other.
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1},
                    {1, 1, 1}, {1, 0.5, 1}},
    {{0, 2, 1}, {1, 2, 3}, {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6},
      {1, 3, 5}, {3, 7, 5}, {4, 5, 8}, {4, 8, 6}, {8, 7, 6}}};
  EXPECT_EQ(report(mesh).widestSlit, 0);
  EXPECT_TRUE(report(mesh).isClosedExceptForSlits());
  EXPECT_FALSE(report(mesh).canBeWelded());
}

TEST(SurfaceReport, KeepsItsVolumeFarFromTheOrigin)
{
  const Point far(4e6, -3e6, 5e6);
  const SurfaceReport moved = report(cube(far, far + Point(1, 1, 1)));
  EXPECT_DOUBLE_EQ(moved.volume, 1);
  EXPECT_DOUBLE_EQ(moved.area, 6);
}

TEST(SurfaceReport, CountsDuplicatesInEitherOrientation)
{
  Mesh mesh = cube();
  mesh.triangles.push_back({mesh.triangles[0][1], mesh.triangles[0][2], mesh.triangles[0][0]});
  mesh.triangles.push_back({mesh.triangles[5][1], mesh.triangles[5][0], mesh.triangles[5][2]});
  mesh.triangles.push_back(mesh.triangles[0]);
  EXPECT_EQ(report(mesh).duplicateTriangles, 3u);
}

TEST(SurfaceReport, CountsTrianglesWithoutArea)
{
  SCOPED_TRACE("seed 131");
  // The vertices of 100 triangles lie on a line of the lattice each, without rounding. The box has
  // an odd centre, which must not give them area.
  Random random(131);
  Mesh mesh = cube({-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5});
  for (Point& p : mesh.points)
  {
    p = p == Point(1.5, 1.5, 1.5) ? Point(1.5 + 1e-9 / 3, 1.5 + 1e-9 / 7, 1.5 + 1e-9 / 11) : p;
  }
  for (int i = 0; i < 100; ++i)
  {
    const auto latticePoint = [&]() -> Point
    {
      return (random.point(-512, 512)).array().round().matrix() / 1024;
    };
    const Point start = latticePoint(), step = latticePoint();
    const auto id = static_cast<std::int32_t>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), {start, start + step, start + 2 * step});
    mesh.triangles.push_back({id, id + 1, id + 2});
  }
  EXPECT_EQ(report(mesh).zeroAreaTriangles, 100u);
}

TEST(CountVertices, CountsDifferentAndUnreferencedPoints)
{
  // The two cubes have four corners in common.
  Mesh mesh = cube().with(cube({1, 0, 0}, {2, 1, 1}));
  const double nan = std::nan("");
  // The points added are two places without triangles, the first twice and the second a corner of a
  // triangle that collapses, then a NaN, and a corner of the first cube once more.
  mesh.points.insert(
    mesh.points.end(), {{7, 7, 7}, {7, 7, 7}, {8, 7, 7}, {nan, 0, 0}, {0, -0.0, 0}});
  mesh.triangles.push_back({18, 18, 0});
  const winding::Surface surface = winding::sanitize({mesh.view()}, serial);
  const winding::VertexCounts counts =
    winding::countVertices({mesh.view().points}, surface, serial);
  EXPECT_EQ(counts.points, 21u);
  EXPECT_EQ(counts.different, 12u + 2u);
  EXPECT_EQ(counts.unreferenced, 2u);
  const winding::VertexCounts none = winding::countVertices({}, winding::Surface(), serial);
  EXPECT_EQ(none.points + none.different + none.unreferenced, 0u);
}

TEST(CountOrientations, CountsOpenPartsThatACapCloses)
{
  const auto countsOf = [](const Mesh& mesh)
  {
    return report(mesh).orientation;
  };
  const auto shifted = [](const Mesh& mesh)
  {
    return mesh.moved({5, 0, 0});
  };
  winding::OrientationCounts counts = countsOf(openCube());
  EXPECT_EQ(counts.closed, 0u);
  EXPECT_EQ(counts.nearlyClosed, 1u);
  EXPECT_EQ(counts.inverted, 0u);
  counts = countsOf(cube().reversed().with(shifted(openCube().reversed())));
  EXPECT_EQ(counts.closed, 1u);
  EXPECT_EQ(counts.nearlyClosed, 1u);
  EXPECT_EQ(counts.inverted, 2u);
  counts = countsOf(cube().part(0, 2)); // a side alone, on which both sides are out
  EXPECT_EQ(counts.nearlyClosed, 0u);
  EXPECT_EQ(counts.inverted, 0u);
}

TEST(CountOrientations, KnowsTheBoreOfAnOpenPipe)
{
  const auto tube = [](double radius, double low, double high, int rings)
  {
    constexpr int sectors = 24;
    Mesh mesh;
    for (int i = 0; i <= rings; ++i)
    {
      for (int j = 0; j < sectors; ++j)
      {
        const double phi = 2 * winding::pi * j / sectors;
        mesh.points.emplace_back(
          radius * std::cos(phi), radius * std::sin(phi), low + (high - low) * i / rings);
      }
    }
    for (int i = 0; i < rings; ++i)
    {
      for (int j = 0; j < sectors; ++j)
      {
        const int a = i * sectors + j, b = i * sectors + (j + 1) % sectors;
        mesh.triangles.push_back({a, b, b + sectors});
        mesh.triangles.push_back({a, b + sectors, a + sectors});
      }
    }
    return mesh;
  };
  const auto countsOf = [](const Mesh& mesh)
  {
    return report(mesh).orientation;
  };
  for (const int rings : {1, 8})
  {
    const Mesh outer = tube(1, 0, 6, rings), bore = tube(0.8, 0, 6, rings);
    const Mesh longBore = tube(0.8, -0.1, 6.1, rings);
    for (const Mesh& inner : {bore, longBore, tube(0.8, 0.1, 5.9, rings)})
    {
      winding::OrientationCounts counts = countsOf(outer.with(inner.reversed()));
      EXPECT_EQ(counts.nearlyClosed, 2u);
      EXPECT_EQ(counts.inverted, 0u) << rings;
      EXPECT_EQ(counts.nestedSolids, 0u) << rings;
      counts = countsOf(outer.reversed().with(inner));
      EXPECT_EQ(counts.inverted, 1u);
      EXPECT_EQ(counts.nestedSolids, 1u);
    }
    // Ends that are cones, and saddles: parts of the bore poke out of the caps.
    for (const bool isSaddle : {false, true})
    {
      const auto bent = [&](const Mesh& mesh)
      {
        return mesh.mapped(
          [&](const Point& q)
          {
            const double cone = 1 - std::hypot(q[0], q[1]), saddle = q[0] * q[0] - q[1] * q[1];
            return Point(q[0], q[1], q[2] * (1 + 0.1 * (isSaddle ? 2 * saddle : 5 * cone)));
          });
      };
      const Mesh pipe = bent(tube(1, -3, 3, rings).with(tube(0.8, -3, 3, rings).reversed()));
      EXPECT_EQ(countsOf(pipe).inverted, 0u) << rings << " " << isSaddle;
      EXPECT_EQ(countsOf(pipe.reversed()).inverted, 1u) << rings << " " << isSaddle;
    }
    EXPECT_EQ(countsOf(outer.reversed()).inverted, 1u);
    const Mesh next = outer.moved({3, 0, 0});
    EXPECT_EQ(countsOf(outer.reversed().with(next.reversed())).inverted, 2u);
    EXPECT_EQ(countsOf(outer.with(next.reversed())).inverted, 1u);
  }
}

TEST(SurfaceReport, VolumeIsAsExactFarFromTheOrigin)
{
  // Both meshes have the same shape to the bit.
  const auto moved = [](const Mesh& mesh, double by)
  {
    return mesh.moved({by, -by, by});
  };
  const Mesh far = moved(icosphere(3), 0x1p23), near = moved(far, -0x1p23);
  EXPECT_NEAR(report(far).volume, report(near).volume, 1e-12);
}
