// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/BoundaryLoops.h"

#include "source/CompareCoordinates.h"
#include "source/Surface.h"
#include "support/LatticeChain.h"
#include "support/Serial.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace
{

using namespace shapes;
using winding::BoundaryChain;
using winding::BoundaryEdge;
using winding::BoundaryLoop;
using winding::BoundaryLoops;
using Edge = std::pair<std::int32_t, std::int32_t>;

/// The number of uses of each edge, signed by their direction from its lower to its higher vertex.
/// Edges with 0 are left out.
using Counts = std::map<Edge, int>;

void addEdge(Counts& counts, std::int32_t from, std::int32_t to, int times)
{
  const Edge edge = std::minmax(from, to);
  counts[edge] += from < to ? times : -times;
  if (counts[edge] == 0)
  {
    counts.erase(edge);
  }
}

Counts countsByDefinition(const winding::Surface& surface)
{
  Counts counts;
  for (const winding::Triangle& t : surface.triangles)
  {
    addEdge(counts, t[0], t[1], 1);
    addEdge(counts, t[1], t[2], 1);
    addEdge(counts, t[2], t[0], 1);
  }
  return counts;
}

Counts countsOf(const BoundaryChain& chain)
{
  Counts counts;
  for (const BoundaryEdge& edge : chain.edges)
  {
    addEdge(counts, edge.from, edge.to, edge.multiplicity);
  }
  return counts;
}

BoundaryLoops loopsOf(const BoundaryChain& chain, const winding::Surface& surface)
{
  const auto loops = winding::boundaryLoops(chain.edges, surface.vertices.size(), serial);
  ShuffledThreads threads(394);
  const auto again = winding::boundaryLoops(chain.edges, surface.vertices.size(), threads);
  EXPECT_EQ(again.size(), loops.size());
  for (std::size_t i = 0; i < std::min(loops.size(), again.size()); ++i)
  {
    EXPECT_TRUE(std::equal(loops[i].begin(), loops[i].end(), again[i].begin(), again[i].end()));
  }
  return loops;
}

Counts countsOf(const BoundaryLoops& loops)
{
  Counts counts;
  for (std::size_t number = 0; number < loops.size(); ++number)
  {
    const BoundaryLoop loop = loops[number];
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      addEdge(counts, loop[i], loop[(i + 1) % loop.size()], 1);
    }
  }
  return counts;
}

/// Expects all that Boundary.h promises of every chain and its loops.
void expectSound(const winding::Surface& surface)
{
  const BoundaryChain chain = boundaryOf(surface);
  ASSERT_EQ(countsOf(chain), countsByDefinition(surface));
  std::vector<int> leavingMinusArriving(surface.vertices.size());
  std::size_t length = 0;
  Edge previous(-1, -1);
  for (const BoundaryEdge& edge : chain.edges)
  {
    ASSERT_GE(edge.multiplicity, 1);
    length += static_cast<std::size_t>(edge.multiplicity);
    leavingMinusArriving[edge.from] += edge.multiplicity;
    leavingMinusArriving[edge.to] -= edge.multiplicity;
    ASSERT_LT(previous, Edge(std::minmax(edge.from, edge.to)));
    previous = std::minmax(edge.from, edge.to);
  }
  for (const int difference : leavingMinusArriving)
  {
    ASSERT_EQ(difference, 0);
  }

  const BoundaryLoops loops = loopsOf(chain, surface);
  // Equal counts and, below, equal total length show that the loops run along no edge there and
  // back.
  ASSERT_EQ(countsOf(loops), countsOf(chain));
  std::size_t loopLength = 0;
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    const BoundaryLoop loop = loops[i];
    loopLength += loop.size();
    ASSERT_GE(loop.size(), 3u);
    ASSERT_EQ(std::set<std::int32_t>(loop.begin(), loop.end()).size(), loop.size());
  }
  ASSERT_EQ(loopLength, length);
}

std::vector<std::size_t> loopSizes(const Mesh& mesh)
{
  const winding::Surface surface = clean(mesh);
  std::vector<std::size_t> sizes;
  const BoundaryLoops loops = loopsOf(boundaryOf(surface), surface);
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    sizes.push_back(loops[i].size());
  }
  return sizes;
}

using Sizes = std::vector<std::size_t>;

} // namespace

TEST(BoundaryChain, OfClosedChainsIsEmpty)
{
  for (const Mesh& mesh : {Mesh(), cube(), tetrahedron(), icosphere(2), torus(12, 8),
         surfaceOf(randomCells(5, 102)), cube().with(cube({0.5, 0.5, 0.5}, {2, 2, 2})),
         cube().with(cube()), openCube().with(openCube().reversed())})
  {
    const winding::Surface surface = clean(mesh);
    const BoundaryChain chain = boundaryOf(surface);
    EXPECT_TRUE(chain.edges.empty());
    EXPECT_EQ(chain.edgesOfOneTriangle, 0u);
    EXPECT_TRUE(loopsOf(chain, surface).empty());
  }
}

TEST(BoundaryChain, OfOneTriangleIsItsSidesAsTheyRun)
{
  const BoundaryChain chain =
    boundaryOf(clean(Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{2, 0, 1}}}));
  ASSERT_EQ(chain.edges.size(), 3u);
  EXPECT_EQ(chain.edgesOfOneTriangle, 3u);
  EXPECT_EQ(countsOf(chain), (Counts{{{0, 1}, 1}, {{1, 2}, 1}, {{0, 2}, -1}}));
}

TEST(BoundaryChain, OfAnOpenCubeIsItsRim)
{
  EXPECT_EQ(boundaryOf(clean(openCube())).edges.size(), 4u);
  EXPECT_EQ(loopSizes(openCube()), Sizes{4});
}

TEST(BoundaryChain, OfAMoebiusStripIsTheRimAndTwiceTheSeamWhereOrientationsDisagree)
{
  const BoundaryChain chain = boundaryOf(clean(moebiusStrip(12)));
  EXPECT_EQ(chain.edgesOfOneTriangle, 24u);
  ASSERT_EQ(chain.edges.size(), 25u);
  std::size_t twice = 0;
  for (const BoundaryEdge& edge : chain.edges)
  {
    twice += edge.multiplicity == 2;
  }
  EXPECT_EQ(twice, 1u);
  expectSound(clean(moebiusStrip(12)));
}

TEST(BoundaryChain, OfABookHasItsSpineOnceForEveryPage)
{
  for (const std::int32_t pages : {1, 2, 3, 7})
  {
    const winding::Surface surface = clean(book(pages));
    EXPECT_EQ(countsOf(boundaryOf(surface))[Edge(0, 1)], pages);
    EXPECT_EQ(loopSizes(book(pages)), Sizes(static_cast<std::size_t>(pages), 3));
    expectSound(surface);
  }
}

TEST(BoundaryChain, OfAFlippedTriangleIsTwiceItsSides)
{
  Mesh mesh = icosphere(1);
  std::swap(mesh.triangles[7][0], mesh.triangles[7][1]);
  const BoundaryChain chain = boundaryOf(clean(mesh));
  EXPECT_EQ(chain.edgesOfOneTriangle, 0u);
  ASSERT_EQ(chain.edges.size(), 3u);
  for (const BoundaryEdge& edge : chain.edges)
  {
    EXPECT_EQ(edge.multiplicity, 2);
  }
  EXPECT_EQ(loopSizes(mesh), (Sizes{3, 3}));
}

TEST(BoundaryChain, OfARepeatedTriangleIsItsSides)
{
  Mesh mesh = icosphere(1);
  mesh.triangles.insert(mesh.triangles.end(), 5, mesh.triangles[7]);
  const BoundaryChain chain = boundaryOf(clean(mesh));
  EXPECT_EQ(chain.edgesOfOneTriangle, 0u);
  ASSERT_EQ(chain.edges.size(), 3u);
  EXPECT_EQ(chain.edges[0].multiplicity, 5);
  EXPECT_EQ(loopSizes(mesh), Sizes(5, 3));
}

TEST(BoundaryLoops, SplitWhereHolesTouchInAVertex)
{
  // Two squares of a plane share a corner: one walk of eight edges would visit it twice.
  const Mesh square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const Mesh other = square.moved({1, 1, 0});
  EXPECT_EQ(loopSizes(square.with(other)), (Sizes{4, 4}));
}

TEST(BoundaryLoops, CoverEveryRandomChainAsOftenAsItSays)
{
  SCOPED_TRACE("seeds 1 … 2000");
  for (unsigned seed = 1; seed <= 2000; ++seed)
  {
    SCOPED_TRACE(seed);
    ASSERT_NO_FATAL_FAILURE(expectSound(randomLatticeChain(seed, 40, 3).surface));
  }
}

TEST(SortedByCoordinates, OrdersManyEdgesAlikeOnAnyThreads)
{
  const winding::Surface sphere = clean(icosphere(5));
  winding::BoundaryEdges edges;
  for (const winding::Triangle& t : sphere.triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (t[i] < t[(i + 1) % 3])
      {
        edges.push_back({t[i], t[(i + 1) % 3], 1});
      }
    }
  }
  ASSERT_GT(edges.size(), 30'000u);
  // Slices of x are of no use where all points, or nearly all, have the same.
  for (const double width : {1.0, 1e-312, 0.0})
  {
    std::vector<Point> vertices;
    for (const Point& vertex : sphere.vertices)
    {
      vertices.emplace_back(width * vertex[0], vertex[1] + 3.7 * vertex[0], vertex[2]);
    }
    const auto ends = [&](const BoundaryEdge& edge)
    {
      const Point &a = vertices[edge.from], &b = vertices[edge.to];
      return winding::compareCoordinates(a, b) < 0 ? std::pair(a, b) : std::pair(b, a);
    };
    const auto sorted = winding::sortedByCoordinates(edges, vertices, serial);
    ShuffledThreads threads(105);
    const auto again =
      winding::sortedByCoordinates({edges.rbegin(), edges.rend()}, vertices, threads);
    for (std::size_t i = 0; i < sorted.size(); ++i)
    {
      ASSERT_EQ(std::pair(sorted[i].from, sorted[i].to), std::pair(again[i].from, again[i].to));
      if (i > 0)
      {
        const auto [lower, higher] = ends(sorted[i - 1]);
        const auto [nextLower, nextHigher] = ends(sorted[i]);
        const int order = winding::compareCoordinates(lower, nextLower);
        ASSERT_LE(order, 0);
        ASSERT_TRUE(order < 0 || winding::compareCoordinates(higher, nextHigher) < 0);
      }
    }
  }
}

TEST(BoundaryLoops, CoverTheRimsOfDamagedShapes)
{
  SCOPED_TRACE("seed 103");
  Random random(103);
  for (const Mesh& whole : {icosphere(3), torus(24, 12), surfaceOf(randomCells(5, 104))})
  {
    for (const double share : {0.01, 0.3, 0.9})
    {
      Mesh mesh{whole.points, {}};
      for (const auto& t : whole.triangles)
      {
        if (random(0, 1) >= share)
        {
          mesh.triangles.push_back(t);
        }
      }
      ASSERT_NO_FATAL_FAILURE(expectSound(clean(mesh)));
    }
  }
}
