// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/OpenParts.h"

#include "field/Field.h"
#include "support/EdgesOf.h"
#include "support/Fields.h"
#include "support/Serial.h"
#include "support/Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace
{

using namespace shapes;
using winding::OpenParts;
using winding::Surface;

Mesh square(double side, double x)
{
  Mesh mesh;
  mesh.points = {{x, -side, -side}, {x, side, -side}, {x, side, side}, {x, -side, side}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

OpenParts openPartsOf(const Mesh& mesh)
{
  const Surface surface = clean(mesh);
  return openPartsInside(surface, edgesOf(surface), serial);
}

TEST(OpenParts, SheetsInsideOfASolidAreFound)
{
  const Mesh box = cube({-1, -1, -1}, {1, 1, 1});
  EXPECT_EQ(openPartsOf(box).count, 0u);
  EXPECT_TRUE(openPartsOf(box).isInside.empty());

  const OpenParts two = openPartsOf(box.with(square(0.5, 0)).with(square(0.6, 0.5).reversed()));
  EXPECT_EQ(two.count, 2u);
  ASSERT_EQ(two.isInside.size(), 16u);
  EXPECT_FALSE(two.isInside[11]);
  EXPECT_TRUE(two.isInside[12]);
  EXPECT_TRUE(two.isInside[15]);
  EXPECT_EQ(openPartsOf(box.reversed().with(square(0.5, 0))).count, 1u) << "w is −1 there";
}

TEST(OpenParts, SheetsOutsideOrThroughTheWallAreNot)
{
  const Mesh box = cube({-1, -1, -1}, {1, 1, 1});
  EXPECT_EQ(openPartsOf(box.with(square(0.5, 3))).count, 0u);
  EXPECT_EQ(openPartsOf(box.with(square(2, 0))).count, 0u);
  EXPECT_EQ(openPartsOf(square(1, 0)).count, 0u) << "there is no solid";
}

TEST(OpenParts, ASheetMayHangOnTheWall)
{
  // The sheet shares an edge of the box, which is closed without it.
  Mesh mesh = cube({-1, -1, -1}, {1, 1, 1});
  const auto corner = [&mesh](const Point& p)
  {
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      if (mesh.points[i] == p)
      {
        return static_cast<std::int32_t>(i);
      }
    }
    return -1;
  };
  const std::int32_t a = corner({-1, -1, -1}), b = corner({-1, -1, 1});
  mesh.points.push_back({0.5, 0.5, 0});
  mesh.triangles.push_back({a, b, static_cast<std::int32_t>(mesh.points.size() - 1)});
  const OpenParts parts = openPartsOf(mesh);
  EXPECT_EQ(parts.count, 1u);
  ASSERT_EQ(parts.isInside.size(), 13u);
  EXPECT_TRUE(parts.isInside[12]);
}

TEST(OpenParts, APartitionMayBeWeldedToTheWallAllRound)
{
  // Two boxes as one solid, with a wall between them.
  Mesh box = cube({-1, -1, -1}, {1, 1, 1});
  const Mesh next = box.mapped([](const Point& p) { return Point(p[0] + 2, p[1], p[2]); });
  const auto isOfWall = [](const Mesh& mesh, const std::array<std::int32_t, 3>& t)
  {
    return mesh.points[t[0]][0] == 1 && mesh.points[t[1]][0] == 1 && mesh.points[t[2]][0] == 1;
  };
  Mesh hull = next;
  hull.triangles.erase(std::remove_if(hull.triangles.begin(), hull.triangles.end(),
                         [&](const auto& t) { return isOfWall(hull, t); }),
    hull.triangles.end());
  ASSERT_EQ(hull.triangles.size(), 10u);
  EXPECT_EQ(openPartsOf(box.with(hull)).count, 1u);
  EXPECT_EQ(openPartsOf(hull.with(box.reversed())).count, 0u) << "the wall may be of either box";
  EXPECT_EQ(openPartsOf(box.with(next)).count, 0u) << "both walls cancel";
}

TEST(OpenParts, SeveralPartitionsAreFoundWhicheverWayTheyLook)
{
  // A tank of four boxes in a row, with the walls between them.
  for (unsigned senses = 0; senses < 8; ++senses)
  {
    Mesh tank;
    for (int i = 0; i < 4; ++i)
    {
      const Mesh box = cube({double(i), 0, 0}, {i + 1.0, 1, 1});
      Mesh side = box;
      side.triangles.clear();
      Mesh wall = side;
      for (const auto& t : box.triangles)
      {
        const double x = (box.points[t[0]][0] + box.points[t[1]][0] + box.points[t[2]][0]) / 3;
        const bool isWall = (x == i && i > 0) || (x == i + 1 && i < 3);
        if (!isWall)
        {
          side.triangles.push_back(t);
        }
        else if (x == i + 1)
        {
          wall.triangles.push_back(t);
        }
      }
      tank = tank.with(side).with((senses >> i & 1u) != 0 ? wall.reversed() : wall);
    }
    EXPECT_EQ(openPartsOf(tank).count, 3u) << senses;
  }
}

TEST(OpenParts, ASheetMayTouchTheWallWithoutAVertexOfIt)
{
  const Mesh box = cube({-1, -1, -1}, {1, 1, 1});
  for (const double side : {1 - 1e-7, 1.0, 1 + 1e-7})
  {
    EXPECT_EQ(openPartsOf(box.with(square(side, 0.25))).count, 1u) << side;
  }
}

TEST(OpenParts, NearlyClosedPartsCountAsSolids)
{
  // The unit cube without its top, and a smaller one in it.
  Mesh open = openCube();
  const Mesh inner =
    open.mapped([](const Point& p) { return Point(Point(0.25, 0.25, 0.25) + 0.5 * p); });
  const auto inCube = [](const Point& p)
  {
    return Point(0.5 + 0.25 * p[0], 0.5 + 0.25 * p[1], 0.5 + 0.25 * p[2]);
  };
  EXPECT_EQ(openPartsOf(open.with(square(1, 0).mapped(inCube))).count, 1u);
  EXPECT_EQ(openPartsOf(open.with(inner)).count, 0u) << "it is nearly closed itself";
}

TEST(OpenParts, AFieldLeavesThemOutIfItIsAskedTo)
{
  const Mesh box = cube({-1, -1, -1}, {1, 1, 1}).with(square(0.9, 0));
  const double places[6] = {0.1, 0, 0, -0.1, 0, 0};
  const auto field = fieldOf(box, &winding::FieldOptions::ignoreOpenParts, true);
  float w[2] = {};
  winding::FieldOutput output;
  output.values = w;
  field->evaluate(winding::VectorsView(places, 2), output, serial);
  EXPECT_EQ(w[0], 1);
  EXPECT_EQ(w[1], 1);
  EXPECT_EQ(field->info().primitives, 12u);
  EXPECT_EQ(field->info().netBoundaryEdges, 0u);
}

} // namespace
