// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/ClosedComponents.h"

#include "base/Bounds.h"
#include "rays/CrossingTree.h"
#include "source/Surface.h"
#include "sums/ReferenceSum.h"
#include "support/Serial.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace shapes;
using winding::Bounds;
using winding::ClosedComponent;
using winding::Components;
using winding::Surface;

Components componentsOf(const Surface& surface)
{
  return winding::componentsOf(surface, winding::edgesOf(surface, serial));
}

std::vector<ClosedComponent> closedComponents(const Mesh& mesh)
{
  const Surface surface = clean(mesh);
  return winding::closedComponents(surface, componentsOf(surface), serial);
}

/// The sense and depth of each closed component.
using Nest = std::vector<std::pair<int, int>>;

Nest nestOf(const Mesh& mesh)
{
  Nest nest;
  for (const ClosedComponent& component : closedComponents(mesh))
  {
    nest.emplace_back(component.sense, component.depth);
  }
  return nest;
}

Mesh box(const Point& center, double halfSide)
{
  const Point half = Point::Constant(halfSide);
  return cube(center - half, center + half);
}

/// The triangles of one component, with their vertices.
Surface partOf(const Surface& surface, const Components& components, std::int32_t component)
{
  Surface part = surface;
  part.triangles.clear();
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    if (components.ofTriangle[i] == component)
    {
      part.triangles.push_back(surface.triangles[i]);
    }
  }
  return part;
}

/// The depths by definition, from sums of solid angles. No vertex may lie on another component.
std::vector<int> naiveDepths(const Mesh& mesh)
{
  const Surface surface = clean(mesh);
  const Components components = componentsOf(surface);
  const auto count = static_cast<std::int32_t>(components.size());
  std::vector<int> depths;
  for (std::int32_t inner = 0; inner < count; ++inner)
  {
    int depth = 0;
    for (std::int32_t outer = 0; outer < count; ++outer)
    {
      bool isInside = outer != inner;
      const Surface around = partOf(surface, components, outer);
      for (const winding::Triangle& t : partOf(surface, components, inner).triangles)
      {
        for (const std::int32_t vertex : t)
        {
          isInside = isInside && std::round(winding::referenceSum<double>(
                                   around, surface.vertices[vertex])) != 0;
        }
      }
      depth += isInside;
    }
    depths.push_back(depth);
  }
  return depths;
}

} // namespace

TEST(CrossingTree, SumsToTheWindingNumber)
{
  for (unsigned seed = 601; seed < 606; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    // The cells of a lattice make rays go through edges and vertices. Of the two spheres, the inner
    // one is inside out.
    const Mesh solid = surfaceOf(randomCells(4, seed))
                         .with(ball({1.7, 2.1, 1.9}, 1.3).with(ball({2.2, 2, 2}, 0.6).reversed()));
    Mesh mesh = solid;
    const std::size_t first = mesh.points.size();
    for (const Point& point : randomPoints(300, -1, 5, seed))
    {
      mesh.points.push_back(point);
    }
    Surface surface = clean(solid);
    const std::size_t own = surface.vertices.size();
    surface.vertices.insert(surface.vertices.end(),
      mesh.points.begin() + static_cast<std::ptrdiff_t>(first), mesh.points.end());
    const std::vector<std::int32_t> part(surface.triangles.size(), 0);
    const std::vector<Bounds> bounds{surface.bounds};
    const winding::CrossingTree tree(surface, part, bounds);
    for (std::size_t v = own; v < surface.vertices.size(); ++v)
    {
      int sum = 0;
      tree.forEachCrossing(
        static_cast<std::int32_t>(v), [&sum](std::int32_t, int crossing) { sum += crossing; });
      EXPECT_EQ(sum, std::lround(winding::referenceSum<double>(surface, surface.vertices[v])));
    }
  }
}

TEST(CrossingTree, IgnoresPartsAroundOthers)
{
  const Surface surface = clean(cube());
  const std::vector<std::int32_t> part(surface.triangles.size(), 0);
  const std::vector<Bounds> none(1);
  const winding::CrossingTree tree(surface, part, none);
  tree.forEachCrossing(0, [](std::int32_t, int) { ADD_FAILURE(); });
}

TEST(ClosedComponents, TellInFromOutByTheVolume)
{
  EXPECT_EQ(nestOf(cube()), (Nest{{1, 0}}));
  EXPECT_EQ(nestOf(torus(12, 8).reversed()), (Nest{{-1, 0}}));
  EXPECT_EQ(nestOf(openCube()), Nest());
  EXPECT_EQ(nestOf(Mesh()), Nest());
  EXPECT_TRUE(closedComponents(cube().reversed())[0].isInverted());
  EXPECT_FALSE(closedComponents(cube())[0].isInverted());
}

TEST(ClosedComponents, LeaveWhatIsFlatWithoutASense)
{
  // Two sheets lie on one another, oriented against each other, and in no plane of the coordinates.
  Mesh sheet{{{0.1, 0.7, 0.3}, {1.3, 0.2, 0.9}, {0.4, 1.1, 0.8}, {0.9, 0.4, 1.7}},
    {{0, 1, 2}, {1, 3, 2}, {0, 2, 1}, {1, 2, 3}}};
  const std::vector<ClosedComponent> flat = closedComponents(sheet);
  for (const ClosedComponent& component : flat)
  {
    EXPECT_EQ(component.sense, 0);
    EXPECT_FALSE(component.isInverted() || component.isNestedSolid());
  }
  EXPECT_GE(flat.size(), 1u);
}

TEST(ClosedComponents, CountWhatTheyLieInside)
{
  Mesh shells;
  for (int i = 0; i < 5; ++i)
  {
    shells = shells.with(i % 2 == 0 ? box({3, 4, 5}, 5 - i) : box({3, 4, 5}, 5 - i).reversed());
  }
  EXPECT_EQ(nestOf(shells), (Nest{{1, 0}, {-1, 1}, {1, 2}, {-1, 3}, {1, 4}}));
  for (const ClosedComponent& shell : closedComponents(shells))
  {
    EXPECT_FALSE(shell.isInverted() || shell.isNestedSolid());
  }
  for (const ClosedComponent& shell : closedComponents(shells.reversed()))
  {
    EXPECT_EQ(shell.isInverted(), shell.depth % 2 == 0);
    EXPECT_EQ(shell.isNestedSolid(), shell.depth % 2 == 1);
  }
}

TEST(ClosedComponents, DoNotLieInsideWhatTheyPokeOutOf)
{
  EXPECT_EQ(nestOf(ball({0, 0, 0}, 1).with(ball({0.6, 0.1, 0}, 0.5))), (Nest{{1, 0}, {1, 0}}));
  const Mesh needle =
    box({0, 0, 0}, 0.5)
      .mapped([](const Point& p) { return Point(0.4 * p[0], 0.4 * p[1], 3 * p[2]); });
  EXPECT_EQ(nestOf(box({0, 0, 0}, 1).with(needle)), (Nest{{1, 0}, {1, 0}}));
}

TEST(ClosedComponents, LieInsideWhatTheyTouchAtAVertex)
{
  // The two cubes have the corner (1, 1, 1) in common.
  const auto movedInside = [](const Point& p)
  {
    return p == Point(1, 1, 1) ? p : Point(p - Point(0.1, 0.2, 0.3));
  };
  const Mesh cavity = cube({0.5, 0.5, 0.5}, {1, 1, 1}).mapped(movedInside).reversed();
  EXPECT_EQ(nestOf(cube().with(cavity)), (Nest{{1, 0}, {-1, 1}}));
  // Two cubes side by side have a corner in common: neither lies in the other.
  EXPECT_EQ(nestOf(cube().with(cube({1, 1, 1}, {2, 2, 2}))), (Nest{{1, 0}, {1, 0}}));
}

TEST(ClosedComponents, LieInsideWhatTheyTouchInAnyDirectionAndOrder)
{
  // One vertex of a smaller sphere is drawn out to a vertex of the one around it. A vertex of both
  // tells nothing, whichever component comes first.
  const Mesh outer = icosphere(1);
  for (const Point& touched : outer.points)
  {
    const Mesh inner =
      outer.mapped([&](const Point& p) { return Point(p == touched ? p : Point(0.5 * p)); });
    EXPECT_EQ(nestOf(outer.with(inner)), (Nest{{1, 0}, {1, 1}})) << touched.transpose();
    EXPECT_EQ(nestOf(inner.with(outer)), (Nest{{1, 1}, {1, 0}})) << touched.transpose();
  }
}

TEST(ClosedComponents, AreThoseOfSumsOfSolidAngles)
{
  for (unsigned seed = 621; seed < 633; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Mesh balls;
    for (int i = 0; i < 14; ++i)
    {
      const Mesh next = ball(random.point(-1, 1), std::pow(2, random(-5, 1)), 1);
      balls = balls.with(random.bits() % 2 == 0 ? next : next.reversed());
    }
    const std::vector<int> naive = naiveDepths(balls);
    std::vector<int> depths;
    for (const auto& [sense, depth] : nestOf(balls))
    {
      depths.push_back(depth);
    }
    EXPECT_EQ(depths, naive);
  }
}

TEST(ClosedComponents, AreTheSameFarAwayAndAtAnySize)
{
  const Mesh nest =
    box({0, 0, 0}, 4)
      .with(box({1, 0, 1}, 2).reversed().with(box({1, 0.5, 1}, 1).with(box({-3, 0, 0}, 0.5))));
  const Nest expected{{1, 0}, {-1, 1}, {1, 2}, {1, 1}};
  EXPECT_EQ(nestOf(nest), expected);
  for (const double scale : {1e-100, 1e-30, 1e30, 1e99})
  {
    EXPECT_EQ(nestOf(nest.scaled(scale)), expected) << scale;
  }
  EXPECT_EQ(nestOf(nest.moved({3e9, -8e9, 5e9})), expected);
  // A speck lies within something large.
  const Mesh speck = box({0.5, 0.25, 0}, 1e-12).with(box({0, 0, 0}, 1e6));
  EXPECT_EQ(nestOf(speck), (Nest{{1, 1}, {1, 0}}));
  EXPECT_TRUE(closedComponents(speck)[0].isNestedSolid());
}

TEST(ClosedComponents, ThousandsOfThemTakeNoTime)
{
  // Half of the boxes lie in a line along the rays, half in a lattice, and all of them in a large
  // one.
  Mesh many = box({5000, 0, 0}, 6000);
  many.points.reserve(90'000);
  for (int i = 0; i < 10'000; ++i)
  {
    const Mesh next = i % 2 == 0
                        ? box({static_cast<double>(i), 0, 0}, 0.3)
                        : box({2000.0 + i % 20, 2.0 + i / 20 % 20, 2.0 + i / 400}, 0.3).reversed();
    const auto shift = static_cast<std::int32_t>(many.points.size());
    many.points.insert(many.points.end(), next.points.begin(), next.points.end());
    for (const auto& t : next.triangles)
    {
      many.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
    }
  }
  const Nest nest = nestOf(many);
  ASSERT_EQ(nest.size(), 10'001u);
  for (std::size_t i = 1; i < nest.size(); ++i)
  {
    EXPECT_EQ(nest[i], std::make_pair(i % 2 == 1 ? 1 : -1, 1)) << i;
  }
}

TEST(ClosedComponents, MayBeNestedAThousandDeep)
{
  SCOPED_TRACE("seed 653");
  Random random(653);
  for (const int deep : {60, 1000})
  {
    // Boxes in boxes, in any order, with two balls between some of them.
    std::vector<std::pair<Mesh, int>> parts;
    for (int i = 0; i < deep; ++i)
    {
      const double size = 10 + i;
      const Mesh outer = box({0, 0, 0}, size);
      parts.emplace_back(i % 3 == 0 ? outer.reversed() : outer, deep - 1 - i);
      if (i % 10 == 9)
      {
        parts.emplace_back(ball({size - 0.5, 0.3, 0.1}, 0.2, 0), deep - i);
        parts.emplace_back(ball({0.5, size - 0.5, 0.7}, 0.3, 0), deep - i);
      }
    }
    for (std::size_t i = parts.size(); i > 1; --i)
    {
      std::swap(parts[i - 1], parts[random.bits() % i]);
    }
    const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(random(0, 6), random.direction()).toRotationMatrix();
    Mesh mesh;
    for (const auto& [part, depth] : parts)
    {
      const auto first = static_cast<std::int32_t>(mesh.points.size());
      for (const Point& point : part.points)
      {
        mesh.points.emplace_back(turn * point);
      }
      for (const auto& t : part.triangles)
      {
        mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
      }
    }
    const std::vector<ClosedComponent> found = closedComponents(mesh);
    ASSERT_EQ(found.size(), parts.size());
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      EXPECT_EQ(found[i].depth, parts[i].second) << i;
      const std::int32_t around = found[i].around;
      ASSERT_EQ(around < 0, found[i].depth == 0) << i;
      EXPECT_EQ(around < 0 ? -1 : parts[around].second, found[i].depth - 1) << i;
    }
  }
}

TEST(ClosedComponents, DependOnNoExecutor)
{
  SCOPED_TRACE("seed 651");
  Random random(651);
  Mesh balls;
  for (int i = 0; i < 40; ++i)
  {
    balls = balls.with(ball(random.point(-1, 1), std::pow(2, random(-5, 0)), 1));
  }
  const Surface surface = clean(balls);
  const Components components = componentsOf(surface);
  ShuffledThreads threads(652);
  const auto expected = winding::closedComponents(surface, components, serial);
  const auto found = winding::closedComponents(surface, components, threads);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_EQ(found[i].depth, expected[i].depth);
  }
}
