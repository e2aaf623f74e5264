// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/Openings.h"

#include "source/SourceArea.h"
#include "support/EdgesOf.h"
#include "support/Serial.h"
#include "support/Shapes.h"
#include "surface/Orientation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace shapes;
using winding::Openings;

Openings openingsOf(const Mesh& mesh)
{
  const winding::Surface surface = clean(mesh);
  return winding::openingsOf(
    boundaryOf(surface).edges, surface, areaOf(surface.vertices, surface.triangles));
}

/// The part of a sphere where some coordinates, the first ones, are 0 or more.
Mesh partOfSphere(int coordinates)
{
  const Mesh ball = icosphere(4);
  Mesh part = ball;
  part.triangles.clear();
  for (const auto& t : ball.triangles)
  {
    const Point middle = (ball.points[t[0]] + ball.points[t[1]] + ball.points[t[2]]) / 3;
    if (middle.head(coordinates).minCoeff() >= 0)
    {
      part.triangles.push_back(t);
    }
  }
  return part;
}

} // namespace

TEST(Openings, AreSharesOfTheArea)
{
  EXPECT_EQ(openingsOf(icosphere(2)).share, 0);
  EXPECT_NEAR(openingsOf(openCube()).share, 0.2, 1e-12);
  EXPECT_NEAR(openingsOf(partOfSphere(1)).share, 0.5, 0.01);    // measured: 0.494
  EXPECT_NEAR(openingsOf(partOfSphere(2)).share, 0.7071, 0.01); // measured: 0.701
  EXPECT_NEAR(openingsOf(partOfSphere(3)).share, 0.866, 0.01);  // measured: 0.862
  EXPECT_FALSE(openingsOf(partOfSphere(1)).areWide());
  EXPECT_TRUE(openingsOf(partOfSphere(2)).areWide());

  Mesh sheet;
  sheet.points = {{5, 0, 1e9}, {6, 0, 1e9}, {6, 1, 1e9}, {5, 1, 1e9}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_NEAR(openingsOf(sheet).share, 1, 1e-12);
  EXPECT_NEAR(openingsOf(sheet.with(sheet.reversed())).share, 0, 1e-12);
}

TEST(Openings, NameThePlanesThatTheyLieIn)
{
  // The upper half of a flat box, without its face at x = 0.
  const Mesh box = cube({0, 0, 0}, {2, 2, 0.3});
  Mesh part = box;
  part.triangles.clear();
  for (const auto& t : box.triangles)
  {
    const Point middle = (box.points[t[0]] + box.points[t[1]] + box.points[t[2]]) / 3;
    if (middle[2] > 0 && middle[0] > 0)
    {
      part.triangles.push_back(t);
    }
  }
  const Openings openings = openingsOf(part);
  EXPECT_NEAR(openings.share, std::hypot(4, 0.6) / 5.8, 1e-12);
  EXPECT_TRUE(openings.areWide());
  EXPECT_EQ(openings.planes, "x = 0 and z = 0");
  EXPECT_NE(openSideAdvice(openings).facts.find("at x = 0 and z = 0"), std::string::npos);
  EXPECT_FALSE(openings.lookInward);
  EXPECT_TRUE(openingsOf(part.reversed()).lookInward);
  EXPECT_EQ(openingsOf(icosphere(1)).planes, "");
  Mesh sheet;
  sheet.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_EQ(openingsOf(sheet).planes, "");
}

TEST(Openings, OfTerrainSayNothingOfItsSide)
{
  // A hill near one side, whose profile there is a part of the rim that goes all round.
  constexpr int n = 20;
  Mesh terrain;
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      const double x = i - 2, y = j - 10;
      terrain.points.emplace_back(i, j, 8 * std::exp(-(x * x + y * y) / 20));
    }
  }
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const int a = i * (n + 1) + j, b = a + n + 1;
      terrain.triangles.push_back({a, b, b + 1});
      terrain.triangles.push_back({a, b + 1, a + 1});
    }
  }
  EXPECT_FALSE(openingsOf(terrain).lookInward);
  EXPECT_FALSE(openingsOf(terrain.reversed()).lookInward);
}

TEST(Openings, LetEachInwardHalfBeTurnedByItself)
{
  const Mesh half = partOfSphere(1);
  const auto at = [&half](double y)
  {
    return half.mapped([y](const Point& p) { return Point(p[0], p[1] + y, p[2]); });
  };
  const Mesh halves = at(0).with(at(3).reversed()).with(at(6)).with(at(9));
  winding::Surface surface = clean(halves);
  const winding::Orientation found = orient(surface, {}, serial);
  EXPECT_EQ(found.components, 1u);
  EXPECT_EQ(found.triangles, half.triangles.size());
}

TEST(Openings, LetAnInwardHalfBeTurned)
{
  for (const int coordinates : {1, 2, 3})
  {
    const Mesh half = partOfSphere(coordinates);
    EXPECT_FALSE(openingsOf(half).lookInward);
    EXPECT_TRUE(openingsOf(half.reversed()).lookInward);
    for (const Mesh& mesh : {half, half.reversed()})
    {
      winding::Surface surface = clean(mesh);
      apply(orient(surface, {}, serial), surface);
      const winding::Openings found = winding::openingsOf(
        boundaryOf(surface).edges, surface, areaOf(surface.vertices, surface.triangles));
      EXPECT_FALSE(found.lookInward) << coordinates;
    }
  }
}
