// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/SplitTriangles.h"

#include "base/Bounds.h"
#include "source/Surface.h"
#include "sums/SolidAngle.h"
#include "support/Serial.h"
#include "support/Shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

namespace
{

using namespace shapes;
using winding::SplitRule;

using Piece = std::array<Point, 3>;

std::vector<Piece> piecesOf(
  const winding::Surface& surface, SplitRule rule, std::size_t mostPieces = 1000000)
{
  std::vector<Piece> pieces;
  rule.mostPieces = mostPieces;
  winding::forEachPiece(rule, surface.vertices, surface,
    [&](const winding::TrianglePiece& piece) {
      pieces.push_back({piece.a, piece.b, piece.c});
    });
  return pieces;
}

std::vector<Piece> trianglesOf(const winding::Surface& surface)
{
  return piecesOf(surface, SplitRule());
}

Point areaOf(const Piece& t)
{
  return 0.5 * (t[1] - t[0]).cross(t[2] - t[0]);
}

double longestSide(const Piece& t)
{
  return std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
}

SplitRule ruleOf(double side, const Point& low = {-10, -10, -10}, const Point& high = {10, 10, 10})
{
  SplitRule rule;
  rule.region = winding::Bounds(low, high);
  rule.longestSide = side;
  return rule;
}

} // namespace

TEST(SplitTriangles, CoverTheWholeTriangle)
{
  SCOPED_TRACE("seeds 371, 372");
  Random random(372);
  double largestArea = 0, largestAngle = 0;
  for (unsigned i = 0; i < 100; ++i)
  {
    const winding::Surface surface = clean(triangleSoup(1, 371 + i));
    const Piece whole = trianglesOf(surface)[0];
    const double side = longestSide(whole) * random(0.05, 0.6);
    const std::vector<Piece> pieces = piecesOf(surface, ruleOf(side));
    EXPECT_GE(pieces.size(), 2u);
    Point area(0, 0, 0);
    double areas = 0, angle = 0;
    const Point q = whole[0] + longestSide(whole) * random.direction();
    for (const Piece& piece : pieces)
    {
      EXPECT_LE(longestSide(piece), side * (1 + 1e-12));
      // All pieces face to the same side of their plane.
      EXPECT_GT(areaOf(piece).dot(areaOf(whole)), 0);
      area += areaOf(piece);
      areas += areaOf(piece).norm();
      angle += winding::solidAngle<double>(piece[0] - q, piece[1] - q, piece[2] - q);
    }
    const double expected = winding::solidAngle<double>(whole[0] - q, whole[1] - q, whole[2] - q);
    largestArea = std::max({largestArea, (area - areaOf(whole)).norm() / areaOf(whole).norm(),
      areas / areaOf(whole).norm() - 1});
    largestAngle = std::max(largestAngle, std::abs(angle - expected));
  }
  record("area", largestArea);
  record("angle", largestAngle);
  EXPECT_LT(largestArea, 1e-12);  // measured: 4e-14
  EXPECT_LT(largestAngle, 1e-12); // measured: 2e-14
}

TEST(SplitTriangles, MayBeLargeFarFromTheSamples)
{
  SCOPED_TRACE("seed 373");
  const winding::Surface surface = clean(triangleSoup(300, 373));
  const SplitRule rule = ruleOf(0.01, {-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1});
  std::size_t large = 0;
  for (const Piece& piece : piecesOf(surface, rule))
  {
    EXPECT_LE(longestSide(piece), rule.allowedFor(piece[0], piece[1], piece[2]) * (1 + 1e-12));
    large += longestSide(piece) > 0.01;
  }
  record("large", static_cast<double>(large));
  EXPECT_GT(large, 300u); // measured: 1383
  EXPECT_EQ(rule.allowedFor({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0.01);
  // The triangle is 4 away along x and 3 along y.
  EXPECT_DOUBLE_EQ(rule.allowedFor({4.1, 3.1, 0}, {5, 3.1, 0}, {4.1, 4, 0}), 2.5);
}

TEST(SplitTriangles, StayWholeWhereTheyAreSmallOrFar)
{
  const winding::Surface surface = clean(icosphere(2));
  const auto isWhole = [&](const SplitRule& rule)
  {
    const bool leaves = winding::leavesWhole(rule, surface.vertices, surface.triangles, serial);
    EXPECT_EQ(leaves, piecesOf(surface, rule) == trianglesOf(surface));
    return leaves;
  };
  EXPECT_TRUE(isWhole(SplitRule()));
  EXPECT_TRUE(isWhole(ruleOf(0.4)));
  EXPECT_FALSE(isWhole(ruleOf(0.3))); // the longest side: 0.32
  EXPECT_FALSE(isWhole(ruleOf(0.01, {0, 0, 0}, {1, 1, 1})));
  EXPECT_TRUE(isWhole(ruleOf(0.01, {10, 0, 0}, {11, 1, 1})));
  EXPECT_TRUE(isWhole(ruleOf(1e-300, {1e200, 0, 0}, {1e201, 1, 1})));
}

TEST(SplitTriangles, AreNoMoreThanAskedFor)
{
  const winding::Surface surface = clean(cube());
  for (const std::size_t most : {0, 12, 13, 100, 1000, 20000})
  {
    const std::size_t count = piecesOf(surface, ruleOf(1e-3), most).size();
    EXPECT_LE(count, std::max<std::size_t>(most, 12));
    // Sides twice as long make a quarter of the pieces.
    EXPECT_GT(count * 8, most);
  }
  // There is an end even where a side of nearly 0 is asked for.
  EXPECT_LE(piecesOf(surface, ruleOf(1e-300), 1000).size(), 1000u);
}

TEST(SplitTriangles, OfNeighboursMeetVertexToVertex)
{
  // The pieces of a closed surface are closed: as many meet every edge in either direction.
  SCOPED_TRACE("seed 374");
  for (const Mesh& mesh : {cube(), icosphere(1), torus(9, 7), surfaceOf(randomCells(3, 374))})
  {
    std::map<std::array<double, 6>, int> edges;
    for (const Piece& piece : piecesOf(clean(mesh), ruleOf(0.2)))
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        const Point &a = piece[i], &b = piece[(i + 1) % 3];
        ++edges[{a[0], a[1], a[2], b[0], b[1], b[2]}];
        --edges[{b[0], b[1], b[2], a[0], a[1], a[2]}];
      }
    }
    EXPECT_TRUE(
      std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; }));
  }
}

TEST(SplitTriangles, MayHaveAnyUnitOfLength)
{
  const std::size_t expected = piecesOf(clean(cube()), ruleOf(0.125)).size();
  for (const double scale : {0x1p-1000, 0x1p-300, 0x1p300, 0x1p1000})
  {
    const Point size = Point::Constant(10 * scale);
    EXPECT_EQ(
      piecesOf(cleanScaled(cube(), scale), ruleOf(0.125 * scale, -size, size)).size(), expected);
  }
  // The vertices are at both ends of the range of numbers: the middle of a side must not overflow.
  const Mesh mesh{{{1, 1, 0}, {-1, 1, 0}, {0, -1, 1e-300}}, {{0, 1, 2}}};
  for (const Piece& piece : piecesOf(cleanScaled(mesh, 1e308), ruleOf(1e300), 1000))
  {
    EXPECT_TRUE(piece[0].allFinite() && piece[1].allFinite() && piece[2].allFinite());
  }
}
