// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/Components.h"

#include "source/Surface.h"
#include "support/EdgesOf.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <tuple>

namespace
{

using namespace shapes;
using winding::Components;
using winding::Surface;
using winding::SurfaceEdges;

Components componentsOf(const Mesh& mesh)
{
  const Surface surface = clean(mesh);
  return winding::componentsOf(surface, edgesOf(surface));
}

std::vector<bool> closedness(const Mesh& mesh)
{
  const Components components = componentsOf(mesh);
  return {components.isClosed.begin(), components.isClosed.end()};
}

/// The triangles that use an edge, each with its sense.
using Uses = std::vector<std::pair<std::int32_t, std::int32_t>>;
using EdgeMap = std::map<std::pair<std::int32_t, std::int32_t>, Uses>;

EdgeMap naiveEdges(const Surface& surface)
{
  EdgeMap edges;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    for (std::size_t side = 0; side < 3; ++side)
    {
      const std::int32_t from = surface.triangles[i][side];
      const std::int32_t to = surface.triangles[i][(side + 1) % 3];
      edges[std::minmax(from, to)].emplace_back(static_cast<std::int32_t>(i), from < to ? 1 : -1);
    }
  }
  return edges;
}

EdgeMap asMap(const Surface& surface, const SurfaceEdges& edges)
{
  EdgeMap map;
  // Rims and pairs leave out the senses, which are taken from here.
  const EdgeMap naive = naiveEdges(surface);
  for (const SurfaceEdges::Rim& rim : edges.rims)
  {
    map[{rim.low, rim.high}] = {{rim.triangle, naive.at({rim.low, rim.high})[0].second}};
  }
  for (const SurfaceEdges::Pair& pair : edges.pairs)
  {
    const std::int32_t sense = naive.at({pair.low, pair.high})[0].second;
    map[{pair.low, pair.high}] = {
      {pair.triangles[0], sense}, {pair.triangles[1], pair.agrees ? -sense : sense}};
  }
  for (const SurfaceEdges::Crowd& crowd : edges.crowds)
  {
    Uses& uses = map[{crowd.low, crowd.high}];
    for (const SurfaceEdges::Use* use = edges.begin(crowd); use != edges.end(crowd); ++use)
    {
      uses.emplace_back(use->triangle, use->sense);
    }
  }
  return map;
}

/// Triangles over few vertices, whose edges are used by one to many triangles.
Mesh crowdedMesh(std::size_t triangles, unsigned seed)
{
  Random random(seed);
  Mesh mesh{randomPoints(12, -1, 1, seed), {}};
  for (std::size_t i = 0; i < triangles; ++i)
  {
    const auto id = [&random]
    {
      return static_cast<std::int32_t>(random.bits() % 12);
    };
    mesh.triangles.push_back({id(), id(), id()});
  }
  return mesh;
}

/// The components by definition, found by passing labels on until nothing changes.
std::vector<std::int32_t> naiveComponents(const Surface& surface)
{
  const EdgeMap edges = naiveEdges(surface);
  std::vector<std::int32_t> labels(surface.triangles.size());
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    labels[i] = static_cast<std::int32_t>(i);
  }
  const auto spread = [&](const auto& connects)
  {
    for (bool changes = true; changes;)
    {
      changes = false;
      for (const auto& [edge, uses] : edges)
      {
        for (const auto& a : uses)
        {
          for (const auto& b : uses)
          {
            if (labels[a.first] > labels[b.first] && connects(uses, a.first, b.first))
            {
              labels[a.first] = labels[b.first];
              changes = true;
            }
          }
        }
      }
    }
  };
  spread([](const Uses& uses, std::int32_t, std::int32_t) { return uses.size() == 2; });
  std::map<std::int32_t, bool> open;
  for (const auto& [edge, uses] : edges)
  {
    std::map<std::int32_t, int> nets;
    for (const auto& [triangle, sense] : uses)
    {
      nets[labels[triangle]] += sense;
    }
    for (const auto& [label, net] : nets)
    {
      open[label] = open[label] || net != 0;
    }
  }
  const std::vector<std::int32_t> patches = labels;
  spread([&](const Uses& uses, std::int32_t a, std::int32_t b)
    { return uses.size() == 2 || (open[patches[a]] && open[patches[b]]); });
  return labels;
}

/// Expects each of some closed solids to be a component when all are in one mesh, in any order of
/// the triangles.
void expectOneComponentEach(const std::vector<Mesh>& solids, unsigned seed)
{
  Mesh all;
  std::vector<std::pair<std::array<std::int32_t, 3>, std::size_t>> triangles;
  for (std::size_t i = 0; i < solids.size(); ++i)
  {
    const std::size_t first = all.triangles.size();
    all = all.with(solids[i]);
    for (std::size_t t = first; t < all.triangles.size(); ++t)
    {
      triangles.emplace_back(all.triangles[t], i);
    }
  }
  std::shuffle(triangles.begin(), triangles.end(), std::mt19937(seed));
  all.triangles.clear();
  for (const auto& [triangle, solid] : triangles)
  {
    all.triangles.push_back(triangle);
  }
  const Components components = componentsOf(all);
  EXPECT_EQ(components.size(), solids.size());
  std::set<std::pair<std::size_t, std::int32_t>> pairs;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    pairs.emplace(triangles[t].second, components.ofTriangle[t]);
  }
  EXPECT_EQ(pairs.size(), solids.size());
  EXPECT_EQ(std::count(components.isClosed.begin(), components.isClosed.end(), char(1)),
    static_cast<std::ptrdiff_t>(solids.size()));
}

/// Adds triangles from the rim of a part of a ball to its centre.
Mesh closedByACone(Mesh part)
{
  const auto centre = static_cast<std::int32_t>(part.points.size());
  part.points.emplace_back(0, 0, 0);
  std::map<std::pair<std::int32_t, std::int32_t>, int> uses;
  for (const auto& triangle : part.triangles)
  {
    for (std::size_t side = 0; side < 3; ++side)
    {
      ++uses[std::minmax(triangle[side], triangle[(side + 1) % 3])];
    }
  }
  const std::vector<std::array<std::int32_t, 3>> triangles = part.triangles;
  for (const auto& triangle : triangles)
  {
    for (std::size_t side = 0; side < 3; ++side)
    {
      const std::int32_t from = triangle[side], to = triangle[(side + 1) % 3];
      if (uses[std::minmax(from, to)] == 1)
      {
        part.triangles.push_back({to, from, centre});
      }
    }
  }
  return part;
}

} // namespace

TEST(SurfaceEdges, AreThoseOfAMap)
{
  for (unsigned seed = 511; seed < 531; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Surface surface = clean(crowdedMesh(10 + seed % 7 * 8, seed));
    EXPECT_EQ(asMap(surface, edgesOf(surface)), naiveEdges(surface));
  }
}

TEST(SurfaceEdges, OfTurnedTrianglesAreThoseOfTheTurnedSurface)
{
  SCOPED_TRACE("seed 541");
  Random random(541);
  Surface surface = clean(crowdedMesh(40, 541));
  const SurfaceEdges edges = edgesOf(surface);
  std::vector<char> isTurned;
  for (winding::Triangle& triangle : surface.triangles)
  {
    isTurned.push_back(random.bits() % 2 == 1);
    if (isTurned.back())
    {
      std::swap(triangle[0], triangle[1]);
    }
  }
  EXPECT_EQ(asMap(surface, edges.withTurned(isTurned)), naiveEdges(surface));
}

TEST(SurfaceEdges, DependOnNoExecutor)
{
  const Surface surface = clean(icosphere(4).with(crowdedMesh(60, 551)));
  const SurfaceEdges serial = edgesOf(surface);
  ShuffledThreads threads(552);
  const SurfaceEdges parallel = winding::edgesOf(surface, threads);
  EXPECT_EQ(asMap(surface, parallel), asMap(surface, serial));
  ASSERT_EQ(parallel.pairs.size(), serial.pairs.size());
  for (std::size_t i = 0; i < serial.pairs.size(); ++i)
  {
    EXPECT_EQ(parallel.pairs[i].low, serial.pairs[i].low);
    EXPECT_EQ(parallel.pairs[i].high, serial.pairs[i].high);
  }
}

TEST(Components, AreThoseOfTheDefinition)
{
  for (unsigned seed = 561; seed < 591; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Mesh mesh =
      seed % 2 == 0 ? crowdedMesh(5 + seed % 5 * 5, seed) : surfaceOf(randomCells(3, seed));
    const Surface surface = clean(mesh);
    const Components components = winding::componentsOf(surface, edgesOf(surface));
    const std::vector<std::int32_t> naive = naiveComponents(surface);
    // Components are numbered in the order of their lowest triangles, which are the naive labels.
    std::map<std::int32_t, std::int32_t> numbers;
    for (std::size_t i = 0; i < naive.size(); ++i)
    {
      const auto number = static_cast<std::int32_t>(numbers.size());
      EXPECT_EQ(components.ofTriangle[i], numbers.emplace(naive[i], number).first->second) << i;
    }
    EXPECT_EQ(components.size(), numbers.size());
    std::vector<bool> isClosed(components.size(), true);
    for (const auto& [edge, uses] : naiveEdges(surface))
    {
      std::map<std::int32_t, int> nets;
      for (const auto& [triangle, sense] : uses)
      {
        nets[components.ofTriangle[triangle]] += sense;
      }
      for (const auto& [component, net] : nets)
      {
        isClosed[component] = isClosed[component] && net == 0;
      }
    }
    EXPECT_EQ(std::vector<bool>(components.isClosed.begin(), components.isClosed.end()), isClosed);
  }
}

TEST(Components, TellSolidsApartThatShareAnEdge)
{
  // The solids are told apart also if one of them is inside out.
  EXPECT_EQ(closedness(surfaceOf({{0, 0, 0}, {1, 1, 0}})), (std::vector<bool>{true, true}));
  const Mesh cubes = cube().with(cube({1, 1, 0}, {2, 2, 1}).reversed());
  EXPECT_EQ(closedness(cubes), (std::vector<bool>{true, true}));
}

TEST(Components, JoinRoomsThatShareAWall)
{
  const Mesh rooms = cube().with(
    openCube().mapped([](const Point& p) { return Point(p[0], p[1], -p[2]); }).reversed());
  EXPECT_EQ(closedness(rooms), std::vector<bool>{false});
}

/// Solids with walls of their own touch along whole faces, or edges.
TEST(Components, PartSolidsThatTouch)
{
  SCOPED_TRACE("seed 771");
  std::vector<Mesh> stack, block, turned;
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.234, Eigen::Vector3d(3, 1, 2).normalized()).toRotationMatrix();
  for (int i = 0; i < 8; ++i)
  {
    stack.push_back(cube(Point(0, 0, i), Point(1, 1, i + 1)));
    const Point low(i % 2, i / 2 % 2, i / 4);
    block.push_back(cube(low, low + Point(1, 1, 1)));
    turned.push_back(block.back().mapped([&](const Point& p) -> Point { return turn * p; }));
  }
  expectOneComponentEach(stack, 771);
  expectOneComponentEach(block, 771);
  expectOneComponentEach(turned, 771);
  const Mesh ball = icosphere(3);
  const std::size_t half = ball.triangles.size() / 2;
  expectOneComponentEach(
    {closedByACone(ball.part(0, half)), closedByACone(ball.part(half, 2 * half))}, 771);
  // Prisms that touch along a side.
  const Mesh wedge{{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, 0, 1}, {2, 0, 1}, {1, 1, 1}},
    {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}}};
  const auto mirrored = [](const Point& p) -> Point
  {
    return {p[0], -p[1], p[2]};
  };
  expectOneComponentEach({wedge, wedge.reversed().mapped(mirrored)}, 771);
}

/// Blocks that overlap in a part of both have edges in common, too.
TEST(Components, KeepSolidsThatOverlapTogether)
{
  const Mesh both = surfaceOf(
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0},
      {1, 1, 0}}).with(surfaceOf({{1, 1, 0}, {2, 1, 0}, {1, 2, 0}, {2, 2, 0}}));
  EXPECT_EQ(closedness(both), std::vector<bool>{true});
}

TEST(Components, KeepPolygonsTogether)
{
  // Two triangles without a common edge are said to be one polygon.
  const Mesh mesh{
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {{0, 1, 2}, {3, 4, 5}}};
  const Surface surface = clean(mesh);
  EXPECT_EQ(winding::componentsOf(surface, edgesOf(surface)).size(), 2u);
  EXPECT_EQ(winding::componentsOf(surface, edgesOf(surface), {0, 1}).size(), 1u);
}

TEST(Components, OfNothingAreNone)
{
  EXPECT_EQ(componentsOf(Mesh()).size(), 0u);
  EXPECT_EQ(closedness(moebiusStrip(8)), std::vector<bool>{false});
}
