// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/RepeatedFaces.h"

#include "diagnosis/Diagnosis.h"
#include "field/Field.h"
#include "support/EdgesOf.h"
#include "support/Fields.h"
#include "support/Serial.h"
#include "support/Shapes.h"
#include "surface/Orientation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace
{

using namespace shapes;
using winding::FaceKind;
using winding::Orientation;
using winding::RepeatedFaces;
using winding::Surface;

/// Some of the triangles once more, over the same points, with the other sense or the same.
Mesh withRepeated(Mesh mesh, std::size_t first, std::size_t last, bool isTurned)
{
  for (std::size_t i = first; i < last; ++i)
  {
    auto triangle = mesh.triangles[i];
    if (isTurned)
    {
      std::swap(triangle[1], triangle[2]);
    }
    std::rotate(triangle.begin(), triangle.begin() + i % 3, triangle.end());
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

/// The surface of a mesh once it is oriented.
Surface outward(const Mesh& mesh)
{
  Surface surface = clean(mesh);
  apply(orient(surface, {}, serial), surface);
  return surface;
}

double volumeOf(const Surface& surface)
{
  double volume = 0;
  for (const winding::Triangle& t : surface.triangles)
  {
    volume += surface.vertices[t[0]].dot(surface.vertices[t[1]].cross(surface.vertices[t[2]])) / 6;
  }
  return volume;
}

/// The triangles in any order.
Mesh shuffled(Mesh mesh, Random& random)
{
  for (std::size_t i = mesh.triangles.size(); i > 1; --i)
  {
    std::swap(mesh.triangles[i - 1],
      mesh.triangles[static_cast<std::size_t>(random(0, 1) * static_cast<double>(i))]);
  }
  return mesh;
}

/// Returns a sphere of 10 × 20 patches, each cut along its `first` diagonal or its second.
Mesh patchedSphere(bool first)
{
  constexpr int rings = 10, sectors = 20;
  const double pi = std::acos(-1.0);
  Mesh sphere;
  for (int i = 1; i < rings; ++i)
  {
    for (int j = 0; j < sectors; ++j)
    {
      const double theta = pi * i / rings, phi = 2 * pi * j / sectors;
      sphere.points.emplace_back(
        std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
    }
  }
  const int south = static_cast<int>(sphere.points.size()), north = south + 1;
  sphere.points.emplace_back(0, 0, -1);
  sphere.points.emplace_back(0, 0, 1);
  for (int j = 0; j < sectors; ++j)
  {
    const int next = (j + 1) % sectors;
    for (int i = 0; i + 2 < rings; ++i)
    {
      const int a = i * sectors + j, b = a + sectors, c = b - j + next, d = a - j + next;
      if (first)
      {
        sphere.triangles.push_back({a, b, c});
        sphere.triangles.push_back({a, c, d});
      }
      else
      {
        sphere.triangles.push_back({a, b, d});
        sphere.triangles.push_back({b, c, d});
      }
    }
    sphere.triangles.push_back({north, j, next});
    sphere.triangles.push_back({south, south - sectors + next, south - sectors + j});
  }
  return sphere;
}

/// Cuts the faces of two triangles, which follow each other, along their other diagonals.
Mesh cutOtherwise(Mesh mesh)
{
  for (std::size_t i = 0; i + 1 < mesh.triangles.size(); i += 2)
  {
    auto &first = mesh.triangles[i], &second = mesh.triangles[i + 1];
    const auto isIn = [](const auto& triangle, std::int32_t corner)
    {
      return std::find(triangle.begin(), triangle.end(), corner) != triangle.end();
    };
    while (isIn(second, first[0]))
    {
      std::rotate(first.begin(), first.begin() + 1, first.end());
    }
    const auto opposite = *std::find_if(
      second.begin(), second.end(), [&](std::int32_t corner) { return !isIn(first, corner); });
    second = {first[0], opposite, first[2]};
    first[2] = opposite;
  }
  return mesh;
}

/// Returns a prism over a regular polygon, whose faces are fans from their corners number `apex`.
Mesh fannedPrism(int corners, int apex)
{
  Mesh prism;
  for (int i = 0; i < 2 * corners; ++i)
  {
    const double phi = 2 * std::acos(-1.0) * (i % corners) / corners;
    prism.points.emplace_back(std::cos(phi), std::sin(phi), i / corners);
  }
  const auto addFan = [&](std::vector<int> face)
  {
    std::rotate(
      face.begin(), face.begin() + apex % static_cast<std::ptrdiff_t>(face.size()), face.end());
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
    {
      prism.triangles.push_back({face[0], face[i], face[i + 1]});
    }
  };
  std::vector<int> bottom, top;
  for (int i = 0; i < corners; ++i)
  {
    const int next = (i + 1) % corners;
    bottom.insert(bottom.begin(), i);
    top.push_back(corners + i);
    addFan({i, next, corners + next, corners + i});
  }
  addFan(bottom);
  addFan(top);
  return prism;
}

TEST(RepeatedFaces, WallsOfThreeFacesAreKnownHoweverOneIsCut)
{
  Random random(3701);
  for (int cuts = 0; cuts < 16; ++cuts)
  {
    const auto boxAt = [&](double x, int bit)
    {
      const Mesh box = cube({x, 0, 0}, {x + 1, 1, 1});
      return cuts >> bit & 1 ? cutOtherwise(box) : box;
    };
    const Mesh a = boxAt(0, 0), front = boxAt(1, 1), back = boxAt(1, 2).reversed();
    const Mesh c = boxAt(2, 3);
    for (const Mesh& two : {a.with(front).with(back), a.reversed().with(front).with(back)})
    {
      EXPECT_NEAR(volumeOf(outward(two)), 2, 1e-12) << cuts;
      EXPECT_NEAR(volumeOf(outward(shuffled(two, random))), 2, 1e-12) << cuts;
      EXPECT_NEAR(volumeOf(outward(two.with(c))), 3, 1e-12) << "between two: " << cuts;
      EXPECT_NEAR(volumeOf(outward(shuffled(two.with(c), random))), 3, 1e-12) << cuts;
    }
    const Mesh twice = a.with(front).with(back.reversed()).with(c);
    EXPECT_NEAR(volumeOf(outward(shuffled(twice, random))), 3, 1e-12) << "same sense: " << cuts;
  }
}

TEST(RepeatedFaces, PolygonsAreEqualFromWhateverCornerTheyAreCut)
{
  Random random(3702);
  for (const int corners : {5, 6, 7, 12, 32})
  {
    const double volume = corners * std::sin(2 * std::acos(-1.0) / corners) / 2;
    for (int apex = 0; apex < 4; ++apex)
    {
      const Mesh prism = fannedPrism(corners, 0);
      const Mesh twoSided = prism.with(fannedPrism(corners, apex).reversed());
      EXPECT_TRUE(repeatedFaces(clean(twoSided), {}).cancelAll()) << corners << " " << apex;
      EXPECT_NEAR(volumeOf(outward(twoSided)), volume, 1e-12) << corners << " " << apex;
      EXPECT_NEAR(volumeOf(outward(shuffled(twoSided, random))), volume, 1e-12);
    }
    EXPECT_FALSE(repeatedFaces(clean(fannedPrism(corners, 0)), {}).areAny());
  }

  // A lens of two fans over a ring that is not flat is a solid, a thin one, too.
  for (const double height : {0.2, 0.02, 0.002})
  {
    Mesh lens = fannedPrism(6, 0);
    lens.triangles.resize(0);
    for (int i = 0; i < 6; ++i)
    {
      lens.points[i][2] = i % 2 == 0 ? height : -height;
    }
    for (int i = 1; i < 5; ++i)
    {
      lens.triangles.push_back({0, i, i + 1});
      lens.triangles.push_back({1, (i + 2) % 6, (i + 1) % 6});
    }
    EXPECT_FALSE(repeatedFaces(clean(lens), {}).areAny()) << height;
  }
}

/// A solid that is there twice, or with both senses, and touches others along edges is no wall.
TEST(RepeatedFaces, SolidsThatTouchAlongEdgesStay)
{
  Random random(3703);
  const Mesh box = cube({0, 0, 0}, {1, 1, 1}), other = cube({1, 1, 0}, {2, 2, 1});
  const Mesh third = cube({2, 0, 0}, {3, 1, 1});
  for (const Mesh& again : {box, box.reversed()})
  {
    const Mesh two = box.with(again).with(other);
    EXPECT_NEAR(volumeOf(outward(two)), 2, 1e-12);
    EXPECT_NEAR(volumeOf(outward(shuffled(two, random))), 2, 1e-12);
    EXPECT_NEAR(volumeOf(outward(shuffled(two.with(third), random))), 3, 1e-12);
    EXPECT_NEAR(volumeOf(outward(shuffled(two.with(other).with(third), random))), 3, 1e-12);
  }
}

TEST(RepeatedFaces, AreKnownByTheirCornersWhereverTheyBegin)
{
  const Mesh ball = icosphere(1); // 80 triangles
  EXPECT_FALSE(repeatedFaces(clean(ball), {}).areAny());

  const RepeatedFaces twice = repeatedFaces(clean(withRepeated(ball, 0, 80, false)), {});
  EXPECT_EQ(twice.repeated, 80u);
  EXPECT_EQ(twice.single, 80u);
  EXPECT_EQ(twice.pairs, 0u);
  EXPECT_FALSE(twice.cancelAll());

  const RepeatedFaces twoSided = repeatedFaces(clean(withRepeated(ball, 0, 80, true)), {});
  EXPECT_EQ(twoSided.pairs, 80u);
  EXPECT_TRUE(twoSided.cancelAll());
  EXPECT_EQ(std::count(twoSided.kinds.begin(), twoSided.kinds.end(), FaceKind::facing), 80);
  EXPECT_EQ(twoSided.kinds[80], FaceKind::opposite);

  EXPECT_FALSE(repeatedFaces(clean(withRepeated(ball, 0, 79, true)), {}).cancelAll());
}

TEST(RepeatedFaces, PolygonsAreEqualHoweverTheyAreCut)
{
  // The square (0 1 2 3), and round the other way (3 2 1 0), which is cut along the other diagonal.
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {3, 2, 1}, {3, 1, 0}};
  const Surface surface = clean(mesh);
  EXPECT_EQ(repeatedFaces(surface, {0, 1, 0, 1}).pairs, 1u);
  EXPECT_TRUE(repeatedFaces(surface, {0, 1, 0, 1}).cancelAll());
  EXPECT_TRUE(repeatedFaces(surface, {}).cancelAll()) << "as triangles of a flat quadrilateral";
  EXPECT_TRUE(repeatedFaces(surface, {0, 1, 0, 0}).cancelAll());

  // The same corners in another order are another face.
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 1, 3}};
  EXPECT_FALSE(repeatedFaces(clean(mesh), {0, 1, 0, 1}).areAny());
}

TEST(RepeatedFaces, TrianglesOfQuadrilateralsAreEqualHoweverTheyAreCut)
{
  const Mesh sphere = patchedSphere(true); // 360 triangles
  const double volume = volumeOf(clean(sphere));
  for (const bool isTurned : {false, true})
  {
    const Mesh again = isTurned ? patchedSphere(false).reversed() : patchedSphere(false);
    const RepeatedFaces faces = repeatedFaces(clean(sphere.with(again)), {});
    EXPECT_EQ(faces.pairs + faces.repeated, 200u); // 160 patches and 40 triangles
    EXPECT_EQ(faces.cancelAll(), isTurned);
    for (unsigned seed = 1; seed <= 5; ++seed)
    {
      Random random(seed);
      const Surface once = outward(shuffled(sphere.with(again), random));
      EXPECT_EQ(once.triangles.size(), 360u) << seed;
      EXPECT_NEAR(volumeOf(once), volume, 1e-12) << seed; // patches are plane
    }
  }
  EXPECT_FALSE(repeatedFaces(clean(sphere), {}).areAny());
  // Two tetrahedra at an edge.
  const Mesh thin =
    tetrahedron().mapped([](const Point& p) { return Point(p[0], p[1], 0.3 * p[2]); });
  EXPECT_FALSE(repeatedFaces(clean(thin.with(thin.moved({1, 0, 0}))), {}).areAny());
}

TEST(RepeatedFaces, OneOfEachPairGivesTheSolidBack)
{
  const Mesh ball = icosphere(2); // 320 triangles
  const double volume = volumeOf(clean(ball));
  for (const Mesh& solid : {ball, ball.reversed()})
  {
    for (const bool isTurned : {false, true})
    {
      for (const std::size_t last : {1u, 160u, 319u, 320u})
      {
        const Surface surface = outward(withRepeated(solid, 0, last, isTurned));
        EXPECT_EQ(surface.triangles.size(), 320u) << last;
        EXPECT_EQ(surface.vertices.size(), clean(ball).vertices.size());
        EXPECT_NEAR(volumeOf(surface), volume, 1e-12) << last; // measured: 2e-15
      }
    }
  }
  // A ball drawn from both sides, and then its faces once more.
  const Surface thrice = outward(withRepeated(withRepeated(ball, 0, 320, true), 100, 600, false));
  EXPECT_EQ(thrice.triangles.size(), 320u);
  EXPECT_NEAR(volumeOf(thrice), volume, 1e-12);
}

TEST(RepeatedFaces, WallsOfSolidsThatTouchStay)
{
  // Two cubes with a wall in common, which each of them has.
  const Surface stack = outward(cube().with(cube().moved({0, 0, 1})));
  EXPECT_EQ(stack.triangles.size(), 24u);
  EXPECT_NEAR(volumeOf(stack), 2, 1e-12);

  // One of them drawn from both sides is a solid by itself.
  const Mesh twoSided = withRepeated(cube(), 0, 12, true);
  const Surface both = outward(cube().moved({3, 0, 0}).with(twoSided));
  EXPECT_EQ(both.triangles.size(), 24u);
  EXPECT_NEAR(volumeOf(both), 2, 1e-12);
}

TEST(RepeatedFaces, NoWallStaysWhereASolidThatTouchesLooksInward)
{
  const Mesh stack = cube().with(cube().reversed().moved({0, 0, 1}));
  EXPECT_EQ(repeatedFaces(clean(stack), {}).repeated, 2u);
  EXPECT_EQ(outward(stack).triangles.size(), 20u);
  EXPECT_NEAR(volumeOf(outward(stack)), 2, 1e-12);

  // Five boxes in a column, some of them inward, in any order of faces.
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    Mesh column;
    for (int i = 0; i < 5; ++i)
    {
      const Mesh box = random(0, 1) < 0.5 ? cube().reversed() : cube();
      column = column.with(box.moved(Point(0, 0, i)));
    }
    EXPECT_NEAR(volumeOf(outward(shuffled(column, random))), 5, 1e-12);
  }
}

TEST(RepeatedFaces, NoWallStaysWhereASolidThatTouchesIsDrawnFromBothSides)
{
  // Five boxes in a column, some of them from both sides, in any order of faces.
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    Mesh block;
    for (int i = 0; i < 5; ++i)
    {
      const Mesh box = cube().moved(Point(0, 0, i));
      block = block.with(i == 2 || random(0, 1) < 0.5 ? withRepeated(box, 0, 12, true) : box);
    }
    EXPECT_NEAR(volumeOf(outward(shuffled(block, random))), 5, 1e-12);
  }
}

/// Boxes of a block, some of them missing, inverted, drawn twice or from both sides, or with faces
/// turned or cut otherwise.
TEST(RepeatedFaces, BoxesOfABlockAreSolidsWhateverIsWrongWithThem)
{
  const std::array<std::array<int, 3>, 4> blocks = {{{2, 1, 1}, {2, 2, 1}, {2, 2, 2}, {3, 3, 3}}};
  for (unsigned seed = 1; seed <= 400; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const std::array<int, 3>& block = blocks[seed % blocks.size()];
    Mesh mesh;
    std::vector<Point> places;
    std::vector<float> expected;
    for (int n = 0; n < block[0] * block[1] * block[2]; ++n)
    {
      const Point corner(n % block[0], n / block[0] % block[1], n / block[0] / block[1]);
      places.emplace_back(corner + Point(0.4, 0.55, 0.6));
      const double state = random(0, 6);
      expected.push_back(state < 1 ? 0.0F : 1.0F);
      if (state < 1)
      {
        continue;
      }
      Mesh box = cube(corner, corner + Point(1, 1, 1));
      if (random(0, 1) < 0.5)
      {
        box = cutOtherwise(box);
      }
      for (std::size_t face = 0; face < 12 && state < 3; face += 2)
      {
        if (random(0, 1) < 0.25)
        {
          std::swap(box.triangles[face][0], box.triangles[face][1]);
          std::swap(box.triangles[face + 1][0], box.triangles[face + 1][1]);
        }
      }
      mesh = mesh.with(state < 4   ? box
                       : state < 5 ? box.reversed()
                                   : withRepeated(box, 0, 12, random(0, 1) < 0.5));
    }
    mesh = shuffled(mesh, random);
    const auto field = fieldOf(mesh, &winding::FieldOptions::orientFaces, true);
    std::vector<float> w(places.size());
    winding::FieldOutput output;
    output.values = w.data();
    field->evaluate(winding::VectorsView(places.front().data(), places.size()), output, serial);
    EXPECT_EQ(w, expected);
  }
}

/// Each face of a cavity between boxes is of one box, and each wall holds faces of two.
TEST(RepeatedFaces, CavitiesBetweenDoubledBoxesStayEmpty)
{
  Random random(3706);
  for (int way = 0; way < 3; ++way)
  {
    Mesh mesh;
    for (int n = 0; n < 27; ++n)
    {
      const Point corner(n % 3, n / 3 % 3, n / 9);
      const Mesh box = cube(corner, corner + Point(1, 1, 1));
      if (n != 13)
      {
        mesh = mesh.with(withRepeated(box, 0, 12, way == 0 || (way == 1 && random(0, 1) < 0.5)));
      }
    }
    EXPECT_NEAR(volumeOf(outward(shuffled(mesh, random))), 26, 1e-9) << way;
  }
}

TEST(RepeatedFaces, TheMajorityOfThreeStands)
{
  const Mesh ball = icosphere(1); // 80 triangles
  const Mesh three = withRepeated(withRepeated(ball, 0, 80, true), 0, 80, false);
  const RepeatedFaces faces = repeatedFaces(clean(three), {});
  EXPECT_EQ(faces.pairs, 0u);
  EXPECT_EQ(faces.single, 80u);
  EXPECT_EQ(faces.repeated, 160u);
  EXPECT_EQ(faces.kinds[0], FaceKind::first);
}

TEST(RepeatedFaces, AnOpenSheetKeepsOneSideUnlessItIsInsideOfASolid)
{
  Mesh sheet;
  sheet.points = {{0.2, 0.2, 0.5}, {0.8, 0.2, 0.5}, {0.8, 0.8, 0.5}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 1}};
  EXPECT_EQ(outward(sheet).triangles.size(), 1u);
  EXPECT_EQ(outward(cube().with(sheet)).triangles.size(), 12u) << "it bounded nothing before";
  EXPECT_EQ(outward(cube().with(sheet.moved({5, 0, 0}))).triangles.size(), 13u);
}

TEST(RepeatedFaces, AFieldTakesThemOnceIfItIsAskedTo)
{
  const Mesh twoSided = withRepeated(icosphere(2), 0, 320, true);
  const double place[3] = {0.1, 0.2, 0.3};
  winding::FieldOptions options;
  for (const bool orients : {false, true})
  {
    options.orientFaces = orients;
    const auto field = fieldOf(twoSided, options);
    float w = -1;
    winding::FieldOutput output;
    output.values = &w;
    field->evaluate(winding::VectorsView(place, 1), output, serial);
    EXPECT_EQ(w, orients ? 1 : 0);
    EXPECT_EQ(field->diagnosis().ofSource(serial).size(), orients ? 0u : 1u);
  }
}

} // namespace
