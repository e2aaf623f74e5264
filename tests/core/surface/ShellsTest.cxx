// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/Shells.h"

#include "support/EdgesOf.h"
#include "support/Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using namespace shapes;
using winding::Shells;
using winding::Surface;
using Region = Shells::Region;

/// The regions before all sides, in the order of the triangles; the last `walls` stand for two.
std::vector<Region> regionsIn(const Mesh& mesh, std::size_t walls)
{
  const Surface surface = clean(mesh);
  std::vector<std::int32_t> counts(surface.triangles.size(), 1);
  std::fill(counts.end() - static_cast<std::ptrdiff_t>(walls), counts.end(), 2);
  return Shells(surface, edgesOf(surface)).regions(counts);
}

/// Whether a triangle has a solid on one side and nothing on the other.
bool isSkin(const std::vector<Region>& regions, std::size_t triangle)
{
  const Region front = regions[2 * triangle], back = regions[2 * triangle + 1];
  return front != back && front != Region::unclear && back != Region::unclear;
}

/// Whether a triangle has solids on both sides.
bool isWall(const std::vector<Region>& regions, std::size_t triangle)
{
  return regions[2 * triangle] == Region::solid && regions[2 * triangle + 1] == Region::solid;
}

/// A prism of `wedges` wedges round the z axis. The walls between them come last, once each and in
/// any sense, two triangles for a wall.
Mesh pie(int wedges)
{
  const double step = 2 * std::acos(-1.0) / wedges;
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {0, 0, 1}};
  for (int i = 0; i < wedges; ++i)
  {
    mesh.points.emplace_back(std::cos(i * step), std::sin(i * step), 0);
    mesh.points.emplace_back(std::cos(i * step), std::sin(i * step), 1);
  }
  for (int i = 0; i < wedges; ++i)
  {
    const int a = 2 + 2 * i, b = 2 + 2 * ((i + 1) % wedges);
    mesh.triangles.push_back({0, b, a});
    mesh.triangles.push_back({1, a + 1, b + 1});
    mesh.triangles.push_back({a, b, b + 1});
    mesh.triangles.push_back({a, b + 1, a + 1});
  }
  for (int i = 0; i < wedges; ++i)
  {
    const int a = 2 + 2 * i;
    mesh.triangles.push_back({0, 1, a});
    mesh.triangles.push_back({1, a, a + 1});
  }
  return mesh;
}

TEST(Shells, WallsLieBetweenBoundedRegions)
{
  Random random(3704);
  for (const int wedges : {3, 4, 5, 12, 100})
  {
    Mesh mesh = pie(wedges);
    for (auto& triangle : mesh.triangles)
    {
      if (random(0, 1) < 0.5)
      {
        std::swap(triangle[0], triangle[1]); // shells do not depend on senses
      }
    }
    for (const Mesh& one : {mesh, mesh.mapped([](const Point& p) { return Point(p * 1e-9); }),
           mesh.moved({1e5, -1e5, 3e5})})
    {
      const std::vector<Region> regions = regionsIn(one, 2 * wedges);
      for (std::size_t i = 0; i < one.triangles.size(); ++i)
      {
        EXPECT_TRUE(i < 4u * wedges ? isSkin(regions, i) : isWall(regions, i))
          << wedges << " " << i;
      }
      // All wedges touch the outside: no wall can have a solid on one side only.
      EXPECT_EQ(regionsIn(one, 0), std::vector<Region>(regions.size(), Region::unclear));
    }
  }
}

TEST(Shells, FrontsLookOutOfOutwardSolids)
{
  const Mesh box = cube({0, 0, 0}, {1, 1, 1});
  for (const Mesh& mesh : {box, box.with(cube({1, 1, 0}, {2, 2, 1})), // along an edge
         box.with(cube({1, 1, 1}, {2, 2, 2})),                        // at a corner
         box.with(cube({0.2, 0.2, 0.2}, {0.8, 0.8, 0.8}))})           // by itself
  {
    const std::vector<Region> regions = regionsIn(mesh, 0);
    const std::vector<Region> inverted = regionsIn(mesh.reversed(), 0);
    for (std::size_t i = 0; i < regions.size(); ++i)
    {
      EXPECT_EQ(regions[i], i % 2 == 0 ? Region::empty : Region::solid);
      EXPECT_EQ(inverted[i], i % 2 == 0 ? Region::solid : Region::empty);
    }
  }
}

TEST(Shells, AreUnclearAtRimsAndWhereTrianglesLieOnOneAnother)
{
  Mesh open = pie(4);
  open.triangles.erase(open.triangles.begin());
  const std::vector<Region> regions = regionsIn(open, 8);
  EXPECT_EQ(regions[0], Region::unclear);
  EXPECT_EQ(regions, std::vector<Region>(regions.size(), Region::unclear)) << "all touch it";

  Mesh sheet;
  sheet.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  sheet.triangles = {{0, 1, 2}};
  EXPECT_EQ(regionsIn(sheet, 0), std::vector<Region>(2, Region::unclear));

  // A second wall that covers the first one in part.
  Mesh covered = pie(4);
  covered.points.emplace_back(0.5, 0, 0);
  covered.triangles.push_back({0, 1, static_cast<int>(covered.points.size()) - 1});
  EXPECT_EQ(regionsIn(covered, 9)[32], Region::unclear);
  EXPECT_EQ(regionsIn(Mesh(), 0), std::vector<Region>());
}

} // namespace
