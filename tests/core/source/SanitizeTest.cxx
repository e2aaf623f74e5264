// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "source/Sanitize.h"
#include "base/Bounds.h"
#include "base/Views.h"
#include "source/PointCloud.h"
#include "source/Surface.h"

#include "base/Refusal.h"
#include "support/Refusals.h"
#include "support/Serial.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace
{

using namespace shapes;
using winding::OrientedPointsView;
using winding::TrianglesView;

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

template <class View> auto sanitize(const std::vector<View>& views)
{
  return winding::sanitize(views, serial);
}

winding::Surface sanitized(const Mesh& mesh)
{
  return sanitize(std::vector<TrianglesView>{mesh.view()});
}

void expectSame(const winding::Surface& a, const winding::Surface& b)
{
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.triangles, b.triangles);
}

template <class Views> void expectUnusable(const Views& views, const std::string& mention)
{
  shapes::expectRefused([&] { sanitize(views); }, mention);
}

} // namespace

TEST(SanitizeSurface, KeepsACleanMeshAsItIs)
{
  const Mesh mesh = icosphere(2);
  const winding::Surface surface = sanitized(mesh);
  EXPECT_EQ(surface.inputTriangles, mesh.triangles.size());
  EXPECT_EQ(surface.dropped() + surface.collapsedTriangles, 0u);
  ASSERT_EQ(surface.triangles.size(), mesh.triangles.size());
  EXPECT_EQ(surface.vertices.size(), mesh.points.size());
  EXPECT_EQ(surface.vertices, mesh.points) << "vertices stand in the order of the points";
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const std::int32_t id = surface.triangles[t][corner];
      ASSERT_EQ(surface.vertices[id], mesh.points[mesh.triangles[t][corner]]);
      ASSERT_TRUE(surface.bounds.contains(surface.vertices[id]));
    }
  }
}

TEST(SanitizeSurface, WeldsExactlyEqualVerticesOnly)
{
  Mesh loose;
  const Mesh solid = cube();
  for (const auto& t : solid.triangles)
  {
    const auto id = static_cast<std::int32_t>(loose.points.size());
    loose.triangles.push_back({id, id + 1, id + 2});
    for (const std::int32_t corner : t)
    {
      loose.points.push_back(solid.points[corner]);
    }
  }
  EXPECT_EQ(sanitized(loose).vertices.size(), 8u);
  loose.points[0][0] = std::nextafter(loose.points[0][0], -1.0);
  EXPECT_EQ(sanitized(loose).vertices.size(), 9u);
}

TEST(SanitizeSurface, WeldsNegativeZeroWithZeroAndHasNoNegativeZero)
{
  const Mesh mesh{
    {{0.0, 1, 0.0}, {1, -0.0, 0.0}, {-0.0, 1, -0.0}, {1, 0.0, -0.0}, {0, 0, 1}, {0, 0, -1}},
    {{0, 1, 4}, {3, 2, 5}}};
  const winding::Surface surface = sanitized(mesh);
  EXPECT_EQ(surface.vertices.size(), 4u);
  for (const Point& vertex : surface.vertices)
  {
    for (const double coordinate : vertex)
    {
      EXPECT_FALSE(coordinate == 0 && std::signbit(coordinate));
    }
  }
}

TEST(SanitizeSurface, DropsAndCountsBadTriangles)
{
  Mesh mesh = cube();
  const auto bad = static_cast<std::int32_t>(mesh.points.size());
  mesh.points.push_back({notANumber, 0, 0});
  mesh.points.push_back({0, infinity, 0});
  mesh.points.push_back({0, 0, -infinity});
  const auto at = mesh.triangles.begin() + 5;
  mesh.triangles.insert(
    at, {{0, 1, bad}, {bad + 1, 1, 2}, {0, bad + 2, 2}, {0, 1, -1}, {0, bad + 3, 1},
          {std::numeric_limits<std::int32_t>::min(), 0, std::numeric_limits<std::int32_t>::max()},
          {3, 3, 4}, {3, 4, 3}, {4, 3, 3}});
  const winding::Surface surface = sanitized(mesh);
  EXPECT_EQ(surface.inputTriangles, 21u);
  EXPECT_EQ(surface.nonFiniteTriangles, 3u);
  EXPECT_EQ(surface.invalidIdTriangles, 3u);
  EXPECT_EQ(surface.collapsedTriangles, 3u);
  EXPECT_EQ(surface.dropped(), 6u);
  expectSame(surface, sanitized(cube()));
}

TEST(SanitizeSurface, CollapsesTrianglesWhoseCornersHaveEqualCoordinates)
{
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {-0.0, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 3}}};
  const winding::Surface surface = sanitized(mesh);
  EXPECT_EQ(surface.collapsedTriangles, 1u);
  EXPECT_EQ(surface.triangles.size(), 1u);
}

TEST(SanitizeSurface, KeepsDuplicateOppositeAndZeroAreaTriangles)
{
  const Mesh mesh{
    {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 0, 0}}, {{0, 1, 2}, {0, 1, 2}, {0, 2, 1}, {0, 1, 3}}};
  EXPECT_EQ(sanitized(mesh).triangles.size(), 4u);
}

TEST(SanitizeSurface, IgnoresPointsWithoutTriangles)
{
  Mesh mesh = cube();
  mesh.points.push_back({100, 0, 0});
  mesh.points.push_back({notANumber, 0, 0});
  expectSame(sanitized(mesh), sanitized(cube()));
  EXPECT_EQ(sanitized(mesh).bounds.max(), Point(1, 1, 1));
}

TEST(SanitizeSurface, IsTheSameForAllTypesAndStrides)
{
  const Mesh mesh = cube({-0.5, 0.25, 3}, {4, 1, 8});
  std::vector<float> floats;
  std::vector<double> strided;
  for (const Point& p : mesh.points)
  {
    floats.insert(floats.end(),
      {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]), nanf("")});
    strided.insert(strided.end(), {p[0], p[1], p[2], notANumber, notANumber});
  }
  std::vector<std::int64_t> wide;
  for (const auto& t : mesh.triangles)
  {
    wide.insert(wide.end(), t.begin(), t.end());
  }
  const std::size_t count = mesh.points.size();
  const winding::TriangleIdsView ids(wide.data(), mesh.triangles.size());
  const winding::Surface expected = sanitized(mesh);
  expectSame(sanitize(std::vector<TrianglesView>{{{floats.data(), count, 4}, ids}}), expected);
  expectSame(sanitize(std::vector<TrianglesView>{
               {{strided.data(), count, 5}, {mesh.triangles[0].data(), mesh.triangles.size()}}}),
    expected);
  wide[3] = std::int64_t(1) << 32; // the id would be 0 if it were cut to 32 bits
  EXPECT_EQ(
    sanitize(std::vector<TrianglesView>{{{floats.data(), count, 4}, ids}}).invalidIdTriangles, 1u);
}

TEST(SanitizeSurface, MakesOneSourceOfSeveralViews)
{
  const Mesh whole = torus(12, 8), first = whole.part(0, 70), second = whole.part(70, 192);
  const winding::Surface surface =
    sanitize(std::vector<TrianglesView>{first.view(), TrianglesView(), second.view()});
  expectSame(surface, sanitized(whole));
  EXPECT_EQ(surface.inputTriangles, 192u);
}

TEST(SanitizeSurface, RefusesWhatIsBadAltogetherAndTakesWhatIsEmpty)
{
  Mesh mesh = cube();
  mesh.points.assign(8, {notANumber, 0, 0});
  mesh.triangles.push_back({0, 1, 99});
  expectUnusable(std::vector<TrianglesView>{mesh.view()}, "all 13 triangles");
  EXPECT_TRUE(sanitize(std::vector<TrianglesView>()).bounds.isEmpty());
  EXPECT_TRUE(sanitized(Mesh()).triangles.empty());
  const Mesh point{{{1, 1, 1}}, {{0, 0, 0}}};
  EXPECT_EQ(sanitized(point).collapsedTriangles, 1u) << "nothing to evaluate is no fault";
}

TEST(SanitizeCloud, NormalizesNormalsOfAllLengths)
{
  SCOPED_TRACE("seed 91");
  Cloud cloud = randomCloud(100, 91);
  const std::vector<Point> directions = cloud.normals;
  for (const double length : {1e-320, 1e-300, 1e-30, 0.5, 1e30, 1e300, 1.7e308})
  {
    for (std::size_t i = 0; i < cloud.normals.size(); ++i)
    {
      cloud.normals[i] = length * directions[i];
    }
    cloud.normals[0] = {length, -length, length};
    const winding::PointCloud clean = shapes::clean(cloud);
    ASSERT_EQ(clean.normals.size(), 100u) << length;
    for (const Point& normal : clean.normals)
    {
      ASSERT_NEAR(normal.norm(), 1, 1e-15) << length;
    }
    EXPECT_LT((clean.normals[0] - Point(1, -1, 1).normalized()).norm(), 1e-15) << length;
  }
}

TEST(SanitizeCloud, DropsAndCountsBadPoints)
{
  std::vector<Point> positions, normals;
  std::vector<double> areas;
  const auto add = [&](const Point& p, const Point& n, double area)
  {
    positions.push_back(p);
    normals.push_back(n);
    areas.push_back(area);
  };
  const Point up(0, 0, 1);
  add({1, 0, 0}, up, 1);
  add({notANumber, 0, 0}, up, 1);
  add({100, 0, 0}, {0, infinity, 0}, 1);
  add({100, 0, 0}, up, notANumber);
  add({100, 0, 0}, {0, -0.0, 0}, 1);
  add({100, 0, 0}, up, -1e-30);
  add({2, 0, 0}, -up, 0);
  const OrientedPointsView view{
    {positions[0].data(), 7}, {normals[0].data(), 7}, {areas.data(), 7}};
  const winding::PointCloud cloud = sanitize(std::vector<OrientedPointsView>{view});
  EXPECT_EQ(cloud.inputPoints, 7u);
  EXPECT_EQ(cloud.nonFinitePoints, 3u);
  EXPECT_EQ(cloud.zeroNormalPoints, 1u);
  EXPECT_EQ(cloud.badAreaPoints, 1u);
  EXPECT_EQ(cloud.dropped(), 5u);
  EXPECT_EQ(cloud.positions, (std::vector<Point>{{1, 0, 0}, {2, 0, 0}}));
  EXPECT_EQ(cloud.normals, (std::vector<Point>{up, -up}));
  EXPECT_EQ(cloud.areas, (std::vector<double>{1, 0}));
  EXPECT_EQ(cloud.bounds.max(), Point(2, 0, 0));
  for (std::size_t i = 0; i < 7; ++i)
  {
    EXPECT_EQ(winding::isUsable(view, i), i == 0 || i == 6) << i;
  }
}

TEST(SanitizeCloud, TakesNormalsWithoutDirectionsForNone)
{
  const std::vector<double> positions = {0, 0, 0, 1, 0, 0}, zeros(6, 0);
  const std::vector<double> mixed = {0, 0, 0, 0, 0, 2};
  const OrientedPointsView empty = {{positions.data(), 2}, {zeros.data(), 2}, {}};
  const winding::PointCloud bare = sanitize(std::vector<OrientedPointsView>{empty, empty});
  EXPECT_EQ(bare.positions.size(), 4u);
  EXPECT_TRUE(bare.normals.empty());
  EXPECT_EQ(bare.dropped(), 0u);
  EXPECT_EQ(boundsOf(std::vector<OrientedPointsView>{empty}).max(), Point(1, 0, 0));
  const OrientedPointsView some = {{positions.data(), 2}, {mixed.data(), 2}, {}};
  const winding::PointCloud cloud = sanitize(std::vector<OrientedPointsView>{empty, some});
  EXPECT_EQ(cloud.normals.size(), 1u) << "where any has a direction, the others are left out";
  EXPECT_EQ(cloud.zeroNormalPoints, 3u);
}

TEST(SanitizeCloud, RefusesWhatIsBadAltogetherAndArraysOfDifferentLengths)
{
  const std::vector<double> nans(12, std::nan("")), ones(12, 1);
  expectUnusable(std::vector<OrientedPointsView>{{{nans.data(), 4}, {ones.data(), 4}, {}}},
    "all points are unusable: give points with a place; of 4, 4 have NaN");
  expectUnusable(
    std::vector<OrientedPointsView>{{{ones.data(), 4}, {ones.data(), 3}, {}}}, "3 normals");
  expectUnusable(
    std::vector<OrientedPointsView>{{{ones.data(), 4}, {ones.data(), 4}, {ones.data(), 5}}},
    "5 areas");
  EXPECT_TRUE(sanitize(std::vector<OrientedPointsView>()).positions.empty());
}

TEST(BoundsOf, AreThoseOfTheSanitizedSource)
{
  Mesh mesh = torus(12, 8);
  const auto bad = static_cast<std::int32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), {{notANumber, 9, 9}, {9, 9, 9}, {-9, -9, -9}});
  mesh.triangles.insert(
    mesh.triangles.end(), {{bad + 1, bad, 0}, {bad + 1, bad + 1, 0}, {bad + 2, 0, 99999}});
  const winding::Bounds bounds = winding::boundsOf(std::vector<TrianglesView>{mesh.view()});
  EXPECT_TRUE(bounds.isApprox(sanitized(mesh).bounds, 0));
  EXPECT_LT(bounds.max()[0], 2);

  Cloud cloud = randomCloud(50, 92);
  cloud.positions[7][0] = notANumber;
  cloud.positions[8] = {9, 9, 9};
  cloud.normals[8] = {0, 0, 0};
  const std::vector<OrientedPointsView> views{cloud.view()};
  EXPECT_TRUE(winding::boundsOf(views).isApprox(sanitize(views).bounds, 0));

  shapes::ShuffledThreads threads(94);
  EXPECT_TRUE(
    winding::boundsOf(std::vector<TrianglesView>{mesh.view()}, threads).isApprox(bounds, 0));
  EXPECT_TRUE(winding::boundsOf(views, threads).isApprox(winding::boundsOf(views), 0));
  EXPECT_TRUE(winding::boundsOf(std::vector<TrianglesView>()).isEmpty());
}

TEST(SanitizeSurface, RefusesCoordinatesOutOfRangeWithTheValueAndTheNumberOfThePoint)
{
  for (const double bad : {1.01e100, -1.01e100, 1e200, -1.7e308})
  {
    Mesh mesh = cube();
    mesh.points.insert(mesh.points.begin(), Point(0.5, 0.5, bad)); // no triangle uses it
    for (auto& triangle : mesh.triangles)
    {
      for (std::int32_t& id : triangle)
      {
        ++id;
      }
    }
    EXPECT_EQ(sanitized(mesh).triangles.size(), 12u);
    mesh.points[3][1] = bad;
    std::ostringstream place;
    place << "point 3 lies at " << mesh.points[3][0] << " " << bad << " " << mesh.points[3][2]
          << ";";
    const std::vector<TrianglesView> one{mesh.view()};
    expectUnusable(one, place.str());
    EXPECT_THROW(winding::boundsOf(one), winding::Refusal);
    const Mesh good = cube();
    expectUnusable(std::vector<TrianglesView>{good.view(), mesh.view()}, "point 3 of part 1 lies");
    mesh.points[3][2] = notANumber;
    EXPECT_GT(sanitized(mesh).nonFiniteTriangles, 0u) << "such points are left out";
  }
  EXPECT_EQ(sanitized(cube({-1e100, 0, 0}, {1e100, 1, 1e-200})).triangles.size(), 12u);
}

TEST(SanitizeSurface, NamesTheFirstPointOutOfRangeOnAnyThreads)
{
  Mesh mesh = torus(200, 100); // several blocks of work
  mesh.points[mesh.triangles[35000][1]][0] = 1e101;
  mesh.points[mesh.triangles[5][2]][0] = 1e102;
  ShuffledThreads threads(3);
  try
  {
    winding::sanitize(std::vector<TrianglesView>{mesh.view()}, threads);
    FAIL() << "not refused";
  }
  catch (const winding::Refusal& refusal)
  {
    const std::string name = "point " + std::to_string(mesh.triangles[5][2]) + " lies at 1e+102";
    EXPECT_EQ(std::string(refusal.what()).rfind(name, 0), 0u) << refusal.what();
  }
}

TEST(SanitizeSurface, RefusesWhatIsTooSmallUnlessItIsOnePlace)
{
  const auto ofSize = [](double size)
  {
    return cube({0, 0, 0}, {size, size / 2, size / 4});
  };
  const Mesh small = ofSize(9.9e-101);
  expectUnusable(std::vector<TrianglesView>{small.view()}, "a length of 9.9e-101 along");
  EXPECT_THROW(winding::boundsOf(std::vector<TrianglesView>{small.view()}), winding::Refusal);
  EXPECT_EQ(sanitized(ofSize(1e-100)).triangles.size(), 12u);
  EXPECT_EQ(sanitized(ofSize(0)).triangles.size(), 0u);
  const Cloud two{{{0, 0, 0}, {0, 1e-150, 0}}, {{0, 0, 1}, {0, 0, 1}}};
  expectUnusable(std::vector<OrientedPointsView>{two.view()}, "a length of 1e-150 along");
  const Cloud one{{{0, 1e-150, 0}, {0, 1e-150, 0}}, {{0, 0, 1}, {0, 0, 1}}};
  EXPECT_EQ(clean(one).positions.size(), 2u);
}

TEST(SanitizeCloud, RefusesPositionsOutOfRangeWhateverTheNormals)
{
  for (const double normal : {0.0, 1.0, infinity, notANumber})
  {
    Cloud cloud = randomCloud(50, 95);
    cloud.positions[17] = {0.5, -1e300, 0.25};
    cloud.normals[17] = {normal, 0, 0};
    const std::vector<OrientedPointsView> views{cloud.view()};
    expectUnusable(views, "point 17 lies at 0.5 -1e+300 0.25;");
    EXPECT_THROW(winding::boundsOf(views), winding::Refusal);
    cloud.positions[17][0] = notANumber;
    EXPECT_EQ(clean(cloud).nonFinitePoints, 1u);
  }
}

TEST(SanitizeCloud, RefusesAreasOutOfRangeWithTheValueAndTheNumberOfThePoint)
{
  const std::vector<Point> up(3, Point(0, 0, 1));
  const auto viewOf = [&](const std::vector<Point>& positions, const std::vector<double>& areas)
  {
    return std::vector<OrientedPointsView>{
      {{positions[0].data(), 3}, {up[0].data(), 3}, {areas.data(), 3}}};
  };
  const std::vector<Point> wide = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}}, place(3, Point(1, 2, 3));
  EXPECT_EQ(sanitize(viewOf(wide, {1, 4e30, 0})).areas[1], 4e30);
  expectUnusable(viewOf(wide, {1, 4.1e30, 0}), "point 1 has the area 4.1e+30; areas");
  expectUnusable(viewOf(wide, {1, 1, 1.7e308}), "point 2 has the area 1.7e+308; areas");
  EXPECT_EQ(sanitize(viewOf(place, {1, 1e210, 0})).areas[1], 1e210);
  expectUnusable(viewOf(place, {1.1e210, 1, 0}), "point 0 has the area 1.1e+210; areas");
  EXPECT_EQ(winding::largestArea({Point(-1e100, 0, 0), Point(1e100, 0, 0)}), 1e210);
}
