#include "surface/Components.h"

#include "source/Surface.h"
#include "support/EdgesOf.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
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
  // The wall is there once in `rooms`, and twice in `doubled`.
  const Mesh rooms = cube().with(
    openCube().mapped([](const Point& p) { return Point(p[0], p[1], -p[2]); }).reversed());
  EXPECT_EQ(closedness(rooms), std::vector<bool>{false});
  const Mesh doubled = cube().with(cube({0, 0, -1}, {1, 1, 0}));
  EXPECT_EQ(closedness(doubled), std::vector<bool>{true});
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
