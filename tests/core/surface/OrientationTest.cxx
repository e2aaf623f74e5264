// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/Orientation.h"

#include "report/SurfaceReport.h"
#include "source/Surface.h"
#include "sums/ReferenceSum.h"
#include "support/EdgesOf.h"
#include "support/Serial.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"
#include "surface/NearlyClosed.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

using namespace shapes;
using winding::Orientation;
using winding::PolygonParts;
using winding::Surface;
using winding::SurfaceEdges;

Orientation orient(const Surface& surface, const PolygonParts& parts = PolygonParts())
{
  return winding::orient(surface, parts, serial);
}

Surface turned(Surface surface, const std::vector<char>& isTurned)
{
  for (std::size_t i = 0; i < isTurned.size(); ++i)
  {
    if (isTurned[i])
    {
      std::swap(surface.triangles[i][0], surface.triangles[i][1]);
    }
  }
  return surface;
}

Surface oriented(const Mesh& mesh)
{
  const Surface surface = clean(mesh);
  return turned(surface, orient(surface).isTurned);
}

/// The mesh with a share of its triangles turned round.
Mesh shuffled(Mesh mesh, unsigned seed, double share = 0.5)
{
  Random random(seed);
  for (auto& triangle : mesh.triangles)
  {
    if (random(0, 1) < share)
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
  return mesh;
}

template <class List> void shuffle(List& list, Random& random)
{
  for (std::size_t i = list.size(); i > 1; --i)
  {
    std::swap(list[i - 1], list[random.bits() % i]);
  }
}

std::size_t disagreements(const Surface& surface)
{
  const SurfaceEdges edges = edgesOf(surface);
  return static_cast<std::size_t>(std::count_if(edges.pairs.begin(), edges.pairs.end(),
    [](const SurfaceEdges::Pair& pair) { return !pair.agrees; }));
}

double windingAt(const Surface& surface, const Point& point)
{
  return winding::referenceSum<double>(surface, point);
}

void expectTriangles(const Surface& surface, const Mesh& mesh)
{
  const Surface expected = clean(mesh);
  ASSERT_EQ(surface.triangles.size(), expected.triangles.size());
  for (std::size_t i = 0; i < expected.triangles.size(); ++i)
  {
    // A triangle that was turned twice starts at another corner.
    std::array<std::int32_t, 3> a = surface.triangles[i], b = expected.triangles[i];
    std::rotate(a.begin(), std::min_element(a.begin(), a.end()), a.end());
    std::rotate(b.begin(), std::min_element(b.begin(), b.end()), b.end());
    EXPECT_EQ(a, b) << "triangle " << i;
  }
}

/// The part of a sphere where z is more than 0.3: a cap for it has two thirds of its area.
Mesh upperPart(Mesh sphere)
{
  sphere.triangles.erase(
    std::remove_if(sphere.triangles.begin(), sphere.triangles.end(),
      [&sphere](const auto& t)
      { return sphere.points[t[0]][2] + sphere.points[t[1]][2] + sphere.points[t[2]][2] < 0.9; }),
    sphere.triangles.end());
  return sphere;
}

} // namespace

TEST(Orientation, LeavesWhatIsOriented)
{
  for (const Mesh& mesh : {cube(), torus(12, 8), openCube(), Mesh(), upperPart(icosphere(3)),
         upperPart(icosphere(3)).reversed(), surfaceOf(randomCells(4, 701)),
         cube().with(cube({0.2, 0.2, 0.2}, {0.8, 0.8, 0.8}).reversed())})
  {
    const Orientation none = orient(clean(mesh));
    EXPECT_EQ(none.triangles, 0u);
    EXPECT_EQ(none.components, 0u);
    EXPECT_EQ(none.isTurned, std::vector<char>(clean(mesh).triangles.size(), 0));
  }
}

/// Expects that a mesh stays as it is, in ten orders of its triangles.
void expectStays(const Mesh& mesh, Random& random)
{
  Mesh ordered = mesh;
  for (int order = 0; order < 10; ++order)
  {
    const Orientation found = orient(clean(ordered));
    ASSERT_EQ(found.triangles, 0u) << order;
    ASSERT_EQ(std::count(found.isLeftOut.begin(), found.isLeftOut.end(), char(1)), 0) << order;
    shuffle(ordered.triangles, random);
  }
}

/// Returns the boxes of a lattice, with a wall of each between two of them.
Mesh boxesOf(int x, int y, int z)
{
  Mesh boxes;
  for (int n = 0; n < x * y * z; ++n)
  {
    const Point corner(n % x, n / x % y, n / x / y);
    boxes = boxes.with(cube(corner, corner + Point(1, 1, 1)));
  }
  return boxes;
}

Mesh without(Mesh mesh, std::size_t triangle)
{
  mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(triangle));
  return mesh;
}

/// Returns a cube whose sides are of n × n squares.
Mesh gridCube(int n, const Point& low, double size)
{
  Cells cells;
  for (int i = 0; i < n * n * n; ++i)
  {
    cells.insert({i % n, i / n % n, i / n / n});
  }
  return surfaceOf(cells).mapped([=](const Point& p) { return Point(low + size / n * p); });
}

TEST(Orientation, LeavesBoxesThatTouchWhicheverTriangleIsMissing)
{
  SCOPED_TRACE("seed 821");
  Random random(821);
  for (const Mesh& boxes : {boxesOf(2, 1, 1), boxesOf(2, 2, 1), boxesOf(3, 3, 1), boxesOf(3, 3, 3)})
  {
    for (std::size_t missing = 0; missing < boxes.triangles.size(); ++missing)
    {
      SCOPED_TRACE(missing);
      expectStays(without(boxes, missing), random);
    }
  }
}

/// Returns whether no edge is left that triangles use twice more in one sense than in the other.
bool agrees(const Surface& surface)
{
  const winding::BoundaryChain chain = boundaryOf(surface);
  return std::all_of(chain.edges.begin(), chain.edges.end(),
    [](const winding::BoundaryEdge& edge) { return edge.multiplicity == 1; });
}

TEST(Orientation, LeavesBoxesThatTouchWhereManyTrianglesAreMissing)
{
  for (unsigned seed = 822; seed < 842; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Mesh boxes = boxesOf(4, 3, 3);
    for (std::size_t missing = 0; missing < 20;)
    {
      const Mesh less = without(boxes, random.bits() % boxes.triangles.size());
      if (agrees(clean(less)))
      {
        boxes = less;
        ++missing;
      }
    }
    expectStays(boxes, random);
  }
}

TEST(Orientation, LeavesCavitiesInASkinWithAHole)
{
  SCOPED_TRACE("seed 832");
  Random random(832);
  const Mesh skin = gridCube(4, {0, 0, 0}, 1), wall = gridCube(4, {0.25, 0.25, 0.25}, 0.5);
  for (std::size_t missing = 0; missing < skin.triangles.size(); missing += 7)
  {
    SCOPED_TRACE(missing);
    expectStays(without(skin, missing).with(wall.reversed()), random);
    expectStays(skin.with(without(wall.reversed(), missing)), random);
  }
  // Whatever the senses are, the cavity is one.
  for (unsigned seed = 842; seed < 862; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random senses(seed);
    const Mesh right = without(skin, senses.bits() % skin.triangles.size()).with(wall.reversed());
    expectTriangles(oriented(shuffled(right, seed, senses(0, 1))), right);
    expectTriangles(oriented(right.part(0, skin.triangles.size() - 1).with(wall)), right);
    expectTriangles(oriented(right.reversed()), right);
  }
  // A ball that looks inward with no other part around it is turned as ever.
  expectTriangles(oriented(without(skin, 5).with(ball({3, 0, 0}, 1).reversed())),
    without(skin, 5).with(ball({3, 0, 0}, 1)));
}

TEST(Orientation, LeavesSolidsThatOverlapAndConformWhicheverTriangleIsMissing)
{
  SCOPED_TRACE("seed 833");
  Random random(833);
  const Mesh both = gridCube(4, {0, 0, 0}, 1).with(gridCube(4, {0.5, 0.5, 0.5}, 1));
  ASSERT_GT(edgesOf(clean(both)).crowds.size(), 0u);
  for (std::size_t missing = 0; missing < both.triangles.size(); missing += 3)
  {
    SCOPED_TRACE(missing);
    expectStays(without(both, missing), random);
  }
}

/// Bars that overlap and share faces, all of which cancel: w is 2 where they overlap.
TEST(Orientation, LeavesBarsThatOverlapAndShareFaces)
{
  SCOPED_TRACE("seed 835");
  Random random(835);
  const auto bar = [](int first, int last)
  {
    Cells cells;
    for (int x = first; x < last; ++x)
    {
      cells.insert({x, 0, 0});
    }
    return surfaceOf(cells);
  };
  expectStays(bar(0, 3).with(bar(2, 5)), random);
  expectStays(bar(0, 3).with(bar(1, 5)).with(bar(2, 4)), random);
}

/// The cap of four walls has half of their area.
TEST(Orientation, OfHalfCappedPartsIsTheSameInAnyOrderAndTurn)
{
  SCOPED_TRACE("seed 834");
  Random random(834);
  Mesh walls = cube().reversed();
  const auto isLid = [&walls](const auto& t)
  {
    const auto& p = walls.points;
    return p[t[0]][2] == p[t[1]][2] && p[t[0]][2] == p[t[2]][2];
  };
  walls.triangles.erase(
    std::remove_if(walls.triangles.begin(), walls.triangles.end(), isLid), walls.triangles.end());
  ASSERT_EQ(walls.triangles.size(), 8u);
  for (int turn = 0; turn < 30; ++turn)
  {
    const Point x = random.direction(), y = x.unitOrthogonal(), z = x.cross(y);
    Mesh turned =
      walls.mapped([&](const Point& p) { return Point(p[0] * x + p[1] * y + p[2] * z); });
    for (int order = 0; order < 5; ++order)
    {
      shuffle(turned.triangles, random);
      EXPECT_EQ(orient(clean(turned)).triangles, 8u) << turn;
    }
  }
}

TEST(Orientation, OfClosedSurfacesIsOutward)
{
  for (const Mesh& mesh : {cube(), tetrahedron(), icosphere(3), torus(24, 16)})
  {
    for (const double share : {0.1, 0.5, 0.9, 1.0})
    {
      SCOPED_TRACE("seed 711, share " + std::to_string(share));
      expectTriangles(oriented(shuffled(mesh, 711, share)), mesh);
    }
  }
}

TEST(Orientation, CountsWhatItTurns)
{
  Mesh mesh = cube().with(ball({5, 5, 5}, 1)).with(ball({-5, 5, 5}, 1).reversed());
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  const Orientation found = orient(clean(mesh));
  EXPECT_EQ(found.triangles, 1u + icosphere(2).triangles.size());
  EXPECT_EQ(found.components, 2u);
  EXPECT_EQ(
    static_cast<std::size_t>(std::count(found.isTurned.begin(), found.isTurned.end(), char(1))),
    found.triangles);
}

TEST(Orientation, OfNestedShellsAlternates)
{
  Mesh shells;
  for (int i = 0; i < 4; ++i)
  {
    const Mesh next = ball({0.1 * i, 0, 0}, 4 - i);
    shells = shells.with(i % 2 == 0 ? next : next.reversed());
  }
  shells = shells.with(ball({9, 0, 0}, 2)).with(ball({9, 0.5, 0}, 1).reversed());
  expectTriangles(oriented(shells), shells);
  expectTriangles(oriented(shells.reversed()), shells);
  expectTriangles(oriented(shuffled(shells, 721)), shells);
}

TEST(Orientation, OfSolidsThatCrossIsOutward)
{
  const Mesh solids = ball({0, 0, 0}, 1).with(ball({0.8, 0, 0}, 0.6)).with(cube());
  expectTriangles(oriented(shuffled(solids, 731)), solids);
}

/// Solids that overlap may have all edges of their intersection in common.
TEST(Orientation, LeavesSolidsThatOverlapAndConform)
{
  const auto block = [](int low, int high)
  {
    Cells cells;
    for (int n = 0; n < 8; ++n)
    {
      cells.insert({low + n % 2 * (high - low - 1), low + n / 2 % 2 * (high - low - 1),
        low + n / 4 * (high - low - 1)});
    }
    return surfaceOf(cells);
  };
  const Mesh both = block(0, 2).with(block(1, 3));
  const Surface surface = clean(both);
  EXPECT_GT(edgesOf(surface).crowds.size(), 0u);
  EXPECT_EQ(orient(surface, {}, serial).triangles, 0u);
}

TEST(Orientation, OfWhatIsNearlyClosedIsOutward)
{
  expectTriangles(oriented(shuffled(openCube(), 741)), openCube());
  Mesh pierced = icosphere(3);
  for (const std::size_t hole : {1000, 500, 499, 3})
  {
    pierced.triangles.erase(pierced.triangles.begin() + static_cast<std::ptrdiff_t>(hole));
  }
  expectTriangles(oriented(shuffled(pierced, 742, 0.95)), pierced);
  // An open cavity lies in an open solid.
  const Mesh inner =
    openCube().mapped([](const Point& p) { return Point(0.3 * p + Point(0.2, 0.3, 0.4)); });
  const Mesh nested = openCube().with(inner.reversed());
  expectTriangles(oriented(shuffled(nested, 743)), nested);
}

TEST(Orientation, OfASolidInAnOpenOneIsOutward)
{
  const Mesh inTub = openCube().with(ball({0.5, 0.5, 0.5}, 0.25));
  expectTriangles(oriented(inTub), inTub);
  expectTriangles(oriented(shuffled(inTub, 744)), inTub);
  const Surface surface = clean(inTub);
  const winding::SurfaceReport report = winding::reportOn(surface, edgesOf(surface), serial);
  EXPECT_EQ(report.orientation.inverted, 0u) << "orient() and the report are of one mind";
  EXPECT_EQ(report.orientation.nestedSolids, 0u);
}

TEST(Orientation, OfOpenSurfacesKeepsMostOfTheirArea)
{
  const Mesh dome = upperPart(icosphere(3));
  expectTriangles(oriented(shuffled(dome, 751, 0.2)), dome);
  expectTriangles(oriented(shuffled(dome, 751, 0.8)), dome.reversed());
  // The area counts, not the number: one large triangle stands against many small ones around it.
  Mesh flat{{{0, 0, 0}, {10, 0, 0}, {0, 10, 0}}, {{0, 1, 2}}};
  for (int i = 0; i < 5; ++i)
  {
    const auto id = static_cast<std::int32_t>(flat.points.size());
    flat.points.push_back({5.0 + i, -0.1 * (i + 1), 0});
    // The small triangles are a fan next to the large one, the wrong way round.
    flat.triangles.push_back({i == 0 ? 0 : id - 1, 1, id});
  }
  const Orientation found = orient(clean(flat));
  EXPECT_FALSE(found.isTurned[0]);
  EXPECT_EQ(disagreements(turned(clean(flat), found.isTurned)), 0u);
}

TEST(Orientation, OfEqualHalvesIsTheSameInAnyOrder)
{
  // A fin stands on a strip, on which its sense makes no difference. Its halves disagree.
  Mesh mesh{
    {{0, 0, 0}, {0, 1, 0}, {3, 0, 0}, {3, 1, 0}, {-3, 0, 0}, {-3, 1, 0}, {0, 0, 1}, {0, 1, 1}},
    {{0, 1, 7}, {0, 7, 6}, {0, 2, 3}, {0, 3, 1}, {4, 0, 1}, {4, 1, 5}}};
  for (int turn = 0; turn < 4; ++turn)
  {
    Mesh fin = mesh;
    std::swap(fin.triangles[turn % 2][1], fin.triangles[turn % 2][2]);
    if (turn >= 2)
    {
      std::swap(fin.triangles[0], fin.triangles[1]);
    }
    const Orientation found = orient(clean(fin));
    // The half that comes first by its coordinates is turned.
    EXPECT_EQ(std::vector<bool>(found.isTurned.begin(), found.isTurned.end()),
      (std::vector<bool>{turn < 2, turn >= 2, false, false, false, false}))
      << turn;
  }
}

TEST(Orientation, LeavesWhatIsOneSided)
{
  const Mesh strip = shuffled(moebiusStrip(20), 761, 0.3);
  const Surface surface = clean(strip);
  EXPECT_EQ(winding::contradictionsOf(surface, edgesOf(surface)).oneSided, 1u);
  EXPECT_EQ(orient(surface).triangles, 0u);
  // A component next to the one-sided one is oriented.
  const Mesh both = strip.with(shuffled(ball({7, 0, 0}, 1), 762));
  const Surface found = oriented(both);
  EXPECT_NEAR(windingAt(found, {7, 0, 0}) - windingAt(clean(strip), {7, 0, 0}), 1, 1e-9);
  EXPECT_EQ(winding::contradictionsOf(found, edgesOf(found)).oneSided, 1u);
  EXPECT_EQ(
    winding::contradictionsOf(clean(icosphere(2)), edgesOf(clean(icosphere(2)))).oneSided, 0u);
  const Surface mixed = clean(shuffled(icosphere(2), 763));
  EXPECT_EQ(winding::contradictionsOf(mixed, edgesOf(mixed)).oneSided, 0u);
}

TEST(Orientation, LeavesWhatIsOneSidedAlsoWhereALargePartMeetsIt)
{
  // A band runs twice along an edge of the strip's rim, in the direction of the strip, so that it
  // is turned to cancel there. It is most of the component.
  Mesh mesh;
  const Surface strip = clean(moebiusStrip(20));
  mesh.points = strip.vertices;
  mesh.triangles.assign(strip.triangles.begin(), strip.triangles.end());
  const SurfaceEdges::Rim rim = edgesOf(strip).rims.front();
  const winding::Triangle& t = strip.triangles[static_cast<std::size_t>(rim.triangle)];
  const std::size_t from = t[0] + t[1] == rim.low + rim.high   ? 0
                           : t[1] + t[2] == rim.low + rim.high ? 1
                                                               : 2;
  const std::int32_t u = t[from], v = t[(from + 1) % 3];
  const auto p = static_cast<std::int32_t>(mesh.points.size()), q = p + 1, m = p + 2, n = p + 3;
  for (const Point& point :
    {Point(0, 10, 50), Point(40, 0, 50), Point(20, 30, 60), Point(9, 9, 99)})
  {
    mesh.points.push_back(point);
  }
  for (const winding::Triangle& triangle :
    {winding::Triangle{u, v, p}, {u, v, q}, {u, p, n}, {u, n, m}, {m, n, q}, {m, q, v}})
  {
    mesh.triangles.push_back(triangle);
  }
  const Orientation found = orient(clean(mesh));
  for (std::size_t i = 0; i < found.isTurned.size(); ++i)
  {
    EXPECT_EQ(found.isTurned[i] != 0, i >= strip.triangles.size()) << i;
  }
}

TEST(Orientation, CancelsWhereManyMeet)
{
  // Two triangles of a sphere are there twice: whatever their orientations, one of each two is as
  // the sphere needs it.
  for (unsigned seed = 771; seed < 781; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mesh mesh = icosphere(2);
    mesh.triangles.push_back(mesh.triangles[40]);
    mesh.triangles.push_back(mesh.triangles[41]);
    const Surface found = oriented(shuffled(mesh, seed));
    EXPECT_EQ(disagreements(found), 0u);
    // Each of the two repeated triangles adds to w, or takes from it, once more.
    const double w = windingAt(found, {0.1, 0.2, -0.1});
    EXPECT_NEAR(w, 1, 0.03); // an extra triangle has 1/320 of the full angle
  }
  // The solids share edges.
  const Mesh cells = surfaceOf({{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {1, 1, 2}, {2, 2, 1}});
  expectTriangles(oriented(shuffled(cells, 782)), cells);
}

TEST(Orientation, TurnsTheSmallestWhereManyMeet)
{
  // Three triangles of different areas run along an edge in one sense. Turning any of them leaves
  // one that nothing cancels.
  const std::vector<Point> points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0.5}, {-2, 1, 0.5}, {0, -4, 0.5}};
  std::array<std::int32_t, 3> apexes = {2, 3, 4}; // in ascending order of their areas
  do
  {
    Mesh mesh{points, {}};
    for (const std::int32_t apex : apexes)
    {
      mesh.triangles.push_back({0, 1, apex});
    }
    const Orientation found = orient(clean(mesh));
    for (std::size_t i = 0; i < 3; ++i)
    {
      EXPECT_EQ(found.isTurned[i] != 0, apexes[i] == 2) << apexes[i];
    }
  } while (std::next_permutation(apexes.begin(), apexes.end()));
}

TEST(Orientation, LeavesSheetsThatCrossAtEdges)
{
  // Two sheets of two triangles cross at a common edge, each of one sense: turning any would gain
  // nothing.
  const Mesh sheets{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0.5}, {-1, 0, 0.5}, {0, 2, 0.5}, {0, -2, 0.5}},
    {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 0, 5}}};
  EXPECT_EQ(orient(clean(sheets)).triangles, 0u);
}

TEST(Orientation, KeepsTheTrianglesOfPolygonsTogether)
{
  SCOPED_TRACE("seed 791");
  // The quadrilaterals of a torus, two triangles each, are turned round as a whole.
  Random random(791);
  const Mesh right = torus(20, 12);
  Mesh mesh = right;
  PolygonParts parts(mesh.triangles.size(), 0);
  for (std::size_t i = 0; i + 1 < mesh.triangles.size(); i += 2)
  {
    parts[i + 1] = 1;
    if (random.bits() % 2 == 1)
    {
      std::swap(mesh.triangles[i][1], mesh.triangles[i][2]);
      std::swap(mesh.triangles[i + 1][1], mesh.triangles[i + 1][2]);
    }
  }
  const Surface surface = clean(mesh);
  const Orientation found = orient(surface, parts);
  for (std::size_t i = 1; i < parts.size(); ++i)
  {
    EXPECT_TRUE(!parts[i] || found.isTurned[i] == found.isTurned[i - 1]);
  }
  expectTriangles(turned(surface, found.isTurned), right);
  // A polygon whose own triangles contradict each other has no orientation.
  Mesh folded = right;
  std::swap(folded.triangles[7][0], folded.triangles[7][1]);
  EXPECT_EQ(orient(clean(folded), parts).triangles, 0u);
}

TEST(Orientation, IsTheSameFarAwayAndAtAnySize)
{
  const Mesh mesh = shuffled(ball({0, 0, 0}, 2).with(ball({0.2, 0, 0}, 1)).with(openCube()), 801);
  const std::vector<char> expected = orient(clean(mesh)).isTurned;
  for (const double scale : {1e-100, 1e99})
  {
    EXPECT_EQ(orient(clean(mesh.scaled(scale))).isTurned, expected);
  }
  EXPECT_EQ(orient(clean(mesh.moved({1e7, -2e7, 3e7}))).isTurned, expected);
}

TEST(Orientation, OfSoupsIsTheSameForEveryExecutorAndEndsSoon)
{
  for (unsigned seed = 811; seed < 816; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    // Few points and many triangles make nearly all edges used by many.
    Random random(seed);
    Mesh mesh{randomPoints(40, -1, 1, seed), {}};
    for (int i = 0; i < 2000; ++i)
    {
      const auto id = [&random]
      {
        return static_cast<std::int32_t>(random.bits() % 40);
      };
      mesh.triangles.push_back({id(), id(), id()});
    }
    const Surface surface = clean(mesh);
    const Orientation expected = orient(surface);
    ShuffledThreads threads(seed);
    const Orientation found = winding::orient(surface, {}, threads);
    EXPECT_EQ(found.isTurned, expected.isTurned);
    EXPECT_EQ(found.components, expected.components);
    // No fewer edges cancel than before.
    const auto uncancelled = [](const Surface& of)
    {
      std::int64_t sum = 0;
      for (const winding::BoundaryEdge& edge : boundaryOf(of).edges)
      {
        sum += edge.multiplicity;
      }
      return sum;
    };
    EXPECT_LE(uncancelled(turned(surface, found.isTurned)), uncancelled(surface));
  }
}

TEST(NearlyClosed, CapsDoNotDependOnTheSideThatIsOut)
{
  for (const std::size_t hole : {5, 20, 60, 100})
  {
    const Mesh mesh = icosphere(2).part(hole, 320);
    const auto capOf = [](const Mesh& open)
    {
      Surface surface = clean(open);
      const SurfaceEdges edges = edgesOf(surface);
      winding::Components components = winding::componentsOf(surface, edges);
      const auto triangles = static_cast<std::ptrdiff_t>(surface.triangles.size());
      winding::capNearlyClosed(surface, edges, components);
      winding::TriangleList cap(surface.triangles.begin() + triangles, surface.triangles.end());
      for (winding::Triangle& t : cap)
      {
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      }
      std::sort(cap.begin(), cap.end());
      return cap;
    };
    winding::TriangleList turned = capOf(mesh.reversed());
    for (winding::Triangle& t : turned)
    {
      std::swap(t[1], t[2]);
    }
    std::sort(turned.begin(), turned.end());
    EXPECT_EQ(turned, capOf(mesh)) << hole;
    EXPECT_FALSE(turned.empty()) << hole;
  }
}

TEST(NearlyClosed, ClosesCapsOfUpToHalfOfTheArea)
{
  // The cap of an open box of height h has 1 / (1 + 4 h) of its area.
  for (const auto& [share, isClosed] : {std::pair(0.48, true), {0.52, false}})
  {
    const double height = (1 / share - 1) / 4;
    Surface surface =
      clean(openCube().mapped([=](const Point& p) { return Point(p[0], p[1], height * p[2]); }));
    const SurfaceEdges edges = edgesOf(surface);
    winding::Components components = winding::componentsOf(surface, edges);
    winding::capNearlyClosed(surface, edges, components);
    EXPECT_EQ(components.isClosed[0] != 0, isClosed) << share;
  }
}

TEST(NearlyClosed, ClosesWhatHasASmallCap)
{
  const auto isClosed = [](const Mesh& mesh)
  {
    Surface surface = clean(mesh);
    const SurfaceEdges edges = edgesOf(surface);
    winding::Components components = winding::componentsOf(surface, edges);
    winding::capNearlyClosed(surface, edges, components);
    EXPECT_EQ(components.ofTriangle.size(), surface.triangles.size());
    if (std::count(components.isClosed.begin(), components.isClosed.end(), char(1)) ==
        static_cast<std::ptrdiff_t>(components.size()))
    {
      EXPECT_TRUE(boundaryOf(surface).edges.empty());
    }
    return std::vector<bool>(components.isClosed.begin(), components.isClosed.end());
  };
  EXPECT_EQ(isClosed(openCube()), std::vector<bool>{true});
  EXPECT_EQ(isClosed(upperPart(icosphere(3))), std::vector<bool>{false});
  EXPECT_EQ(isClosed(moebiusStrip(10)), std::vector<bool>{false});
  EXPECT_EQ(isClosed(cube()), std::vector<bool>{true});
  Mesh flipped = icosphere(1);
  std::swap(flipped.triangles[7][1], flipped.triangles[7][2]);
  EXPECT_EQ(isClosed(flipped), std::vector<bool>{true}) << "its sides are there twice";
  EXPECT_EQ(isClosed(Mesh()), std::vector<bool>());
  // The openings of two boxes have a corner in common, and a triangle touches the same corner.
  const Mesh other =
    openCube().mapped([](const Point& p) { return Point(-p[0], -p[1], 2 - p[2]); });
  const Mesh corner{{{0, 0, 1}, {1, -1, 2}, {1, -2, 2}}, {{0, 1, 2}}};
  EXPECT_EQ(isClosed(openCube().with(other).with(corner)), (std::vector<bool>{true, true, false}));
}
