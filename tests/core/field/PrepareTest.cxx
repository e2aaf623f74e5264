// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/Executor.h"
#include "base/Views.h"
#include "field/Field.h"
#include "source/Sanitize.h"
#include "source/Surface.h"
#include "support/Interruption.h"
#include "support/Serial.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"
#include "surface/Boundary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <tuple>

// These tests prepare surfaces in parallel: the result is the same for every executor, and the work
// can be interrupted.

namespace
{

using namespace shapes;
using winding::Surface;
using winding::TrianglesView;
using Views = std::vector<TrianglesView>;

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

Surface sanitized(const Views& views, winding::Executor& executor)
{
  return winding::sanitize(views, executor);
}

/// The surface that Sanitize.h promises, found in the plainest way.
Surface sanitizedByDefinition(const Views& views)
{
  using Key = std::tuple<double, double, double>;
  const auto keyOf = [](const TrianglesView& view, std::int64_t id) -> Key
  {
    const Point p = view.points[static_cast<std::size_t>(id)];
    return {p[0], p[1], p[2]}; // −0 and 0 are equivalent
  };
  Surface surface;
  std::map<Key, std::int32_t> used;
  std::vector<std::array<Key, 3>> kept;
  for (const TrianglesView& view : views)
  {
    const auto points = static_cast<std::int64_t>(view.points.size());
    for (std::size_t t = 0; t < view.triangles.size(); ++t)
    {
      ++surface.inputTriangles;
      std::array<std::int64_t, 3> ids;
      bool valid = true, finite = true;
      for (std::size_t corner = 0; corner < 3; ++corner)
      {
        ids[corner] = view.triangles(t, corner);
        valid = valid && ids[corner] >= 0 && ids[corner] < points;
      }
      for (std::size_t corner = 0; valid && corner < 3; ++corner)
      {
        finite = finite && view.points[static_cast<std::size_t>(ids[corner])].allFinite();
      }
      surface.invalidIdTriangles += !valid;
      surface.nonFiniteTriangles += valid && !finite;
      if (!valid || !finite)
      {
        continue;
      }
      const std::array<Key, 3> keys = {
        keyOf(view, ids[0]), keyOf(view, ids[1]), keyOf(view, ids[2])};
      if (keys[0] == keys[1] || keys[1] == keys[2] || keys[2] == keys[0])
      {
        ++surface.collapsedTriangles;
        continue;
      }
      kept.push_back(keys);
      for (const Key& key : keys)
      {
        used.emplace(key, -1);
      }
    }
  }
  // Vertices are numbered in the order of the points that kept triangles use.
  std::map<Key, std::int32_t> numbers;
  for (const TrianglesView& view : views)
  {
    std::vector<char> isUsed(view.points.size(), 0);
    for (std::size_t t = 0; t < view.triangles.size(); ++t)
    {
      std::array<std::int64_t, 3> ids = {
        view.triangles(t, 0), view.triangles(t, 1), view.triangles(t, 2)};
      const bool valid = std::all_of(ids.begin(), ids.end(),
        [&](std::int64_t id)
        {
          return id >= 0 && id < static_cast<std::int64_t>(view.points.size()) &&
                 view.points[static_cast<std::size_t>(id)].allFinite();
        });
      if (valid && keyOf(view, ids[0]) != keyOf(view, ids[1]) &&
          keyOf(view, ids[1]) != keyOf(view, ids[2]) && keyOf(view, ids[2]) != keyOf(view, ids[0]))
      {
        for (const std::int64_t id : ids)
        {
          isUsed[static_cast<std::size_t>(id)] = 1;
        }
      }
    }
    for (std::size_t id = 0; id < isUsed.size(); ++id)
    {
      const Key key = isUsed[id] ? keyOf(view, static_cast<std::int64_t>(id)) : Key();
      if (isUsed[id] && numbers.emplace(key, static_cast<std::int32_t>(numbers.size())).second)
      {
        surface.vertices.push_back(view.points[id].array() + 0.0);
        surface.bounds.extend(surface.vertices.back());
      }
    }
  }
  for (const std::array<Key, 3>& keys : kept)
  {
    surface.triangles.push_back({numbers[keys[0]], numbers[keys[1]], numbers[keys[2]]});
  }
  return surface;
}

bool areSameBits(const std::vector<Point>& a, const std::vector<Point>& b)
{
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Point)) == 0);
}

void expectSame(const Surface& found, const Surface& expected)
{
  EXPECT_TRUE(areSameBits(found.vertices, expected.vertices));
  EXPECT_TRUE(found.triangles == expected.triangles);
  EXPECT_EQ(found.bounds.min(), expected.bounds.min());
  EXPECT_EQ(found.bounds.max(), expected.bounds.max());
  EXPECT_EQ(found.inputTriangles, expected.inputTriangles);
  EXPECT_EQ(found.nonFiniteTriangles, expected.nonFiniteTriangles);
  EXPECT_EQ(found.invalidIdTriangles, expected.invalidIdTriangles);
  EXPECT_EQ(found.collapsedTriangles, expected.collapsedTriangles);
}

void expectSame(const winding::BoundaryChain& found, const winding::BoundaryChain& expected)
{
  EXPECT_EQ(found.edgesOfOneTriangle, expected.edgesOfOneTriangle);
  ASSERT_EQ(found.edges.size(), expected.edges.size());
  EXPECT_TRUE(std::equal(found.edges.begin(), found.edges.end(), expected.edges.begin(),
    [](const winding::BoundaryEdge& a, const winding::BoundaryEdge& b)
    { return a.from == b.from && a.to == b.to && a.multiplicity == b.multiplicity; }));
}

/// Expects that a serial executor, threads and the definition agree about the surface and its
/// boundary.
void expectTheSameForAllExecutors(const Views& views, unsigned seed)
{
  ShuffledThreads threads(seed);
  const Surface expected = sanitizedByDefinition(views);
  const Surface surface = sanitized(views, serial);
  expectSame(surface, expected);
  expectSame(sanitized(views, threads), expected);
  expectSame(winding::boundaryChain(surface, threads), winding::boundaryChain(surface, serial));
}

/// The mesh with three points of its own for every triangle.
Mesh loosened(const Mesh& mesh)
{
  Mesh loose;
  for (const auto& t : mesh.triangles)
  {
    const auto first = static_cast<std::int32_t>(loose.points.size());
    loose.triangles.push_back({first, first + 1, first + 2});
    for (const std::int32_t id : t)
    {
      loose.points.push_back(mesh.points[static_cast<std::size_t>(id)]);
    }
  }
  return loose;
}

/// The mesh with everything wrong that can be: NaN, infinity, bad ids, collapsed triangles, −0.
Mesh damaged(Mesh mesh, unsigned seed)
{
  Random random(seed);
  const std::size_t points = mesh.points.size();
  for (std::size_t i = 0; i < points / 50 + 1; ++i)
  {
    Point& p = mesh.points[random.bits() % points];
    p[static_cast<int>(random.bits() % 3)] = i % 3 == 0 ? notANumber : i % 3 == 1 ? HUGE_VAL : -0.0;
  }
  for (std::size_t i = 0; i < mesh.triangles.size() / 20 + 1; ++i)
  {
    auto& t = mesh.triangles[random.bits() % mesh.triangles.size()];
    const auto wrong = static_cast<std::int32_t>(random.bits());
    t[random.bits() % 3] = i % 2 == 0 ? wrong : t[random.bits() % 3];
  }
  return mesh;
}

/// Points on a small lattice with both zeros, most of which occur many times.
Mesh repeatedPoints(std::size_t points, std::size_t triangles, unsigned seed)
{
  Random random(seed);
  Mesh mesh;
  const double values[] = {-1, -0.0, 0.0, 1};
  for (std::size_t i = 0; i < points; ++i)
  {
    mesh.points.push_back(
      {values[random.bits() % 4], values[random.bits() % 4], values[random.bits() % 4]});
  }
  for (std::size_t i = 0; i < triangles; ++i)
  {
    const auto id = [&]
    {
      return static_cast<std::int32_t>(random.bits() % points);
    };
    mesh.triangles.push_back({id(), id(), id()});
  }
  return mesh;
}

} // namespace

TEST(Prepare, IsTheSameForAllExecutorsOnDamagedAndRepeatedInput)
{
  SCOPED_TRACE("seeds 161 … 200");
  for (unsigned seed = 161; seed <= 200; ++seed)
  {
    SCOPED_TRACE(seed);
    const Mesh lattice = repeatedPoints(3 + seed % 60, 100, seed);
    const Mesh sphere = damaged(icosphere(2), seed), soup = damaged(loosened(torus(9, 6)), seed);
    expectTheSameForAllExecutors({lattice.view()}, seed);
    expectTheSameForAllExecutors({TrianglesView(), sphere.view(), TrianglesView(), TrianglesView(),
                                   soup.view(), sphere.view(), lattice.view(), TrianglesView()},
      seed);
  }
}

TEST(Prepare, IsTheSameForAllExecutorsOnLargeInput)
{
  SCOPED_TRACE("seeds 201 … 203");
  const Mesh sphere = icosphere(6);
  expectTheSameForAllExecutors({sphere.view()}, 201);
  const Mesh first = damaged(sphere, 202), second = damaged(loosened(sphere), 203);
  expectTheSameForAllExecutors({first.view()}, 202);
  expectTheSameForAllExecutors({second.view()}, 203);
  expectTheSameForAllExecutors({first.view(), TrianglesView(), second.view()}, 203);
}

TEST(Prepare, OfOneVertexWithManyTrianglesIsRight)
{
  Mesh fan{{{0, 0, 0}}, {}};
  constexpr std::int32_t blades = 5000;
  for (std::int32_t i = 1; i <= blades; ++i)
  {
    fan.points.push_back({std::cos(i), std::sin(i), i * 1e-3});
    fan.triangles.push_back({i, i % blades + 1, 0});
  }
  const Surface surface = clean(fan);
  const winding::BoundaryChain chain = boundaryOf(surface);
  EXPECT_EQ(chain.edges.size(), static_cast<std::size_t>(blades));
  EXPECT_EQ(chain.edgesOfOneTriangle, static_cast<std::size_t>(blades));
  expectTheSameForAllExecutors({fan.view()}, 204);
}

TEST(Prepare, KeepsPointsApartWhoseHashesAreEqual)
{
  // Pairs of points have the same hash by the formula of Weld.cxx: x differs, and y makes up for
  // it.
  const auto afterX = [](double x)
  {
    std::uint64_t hash;
    std::memcpy(&hash, &x, sizeof hash);
    hash *= 0x9E3779B97F4A7C15u;
    return hash ^ hash >> 32;
  };
  Mesh mesh;
  double x = 1;
  for (int found = 0; found < 50;)
  {
    x = std::nextafter(x, 2.0);
    const double y = 0.5;
    std::uint64_t bits;
    std::memcpy(&bits, &y, sizeof bits);
    bits ^= afterX(1) ^ afterX(x);
    double other;
    std::memcpy(&other, &bits, sizeof other);
    if (std::abs(other) <= 1e100) // as far as a source may reach
    {
      mesh.points.push_back({1, y, 3});
      mesh.points.push_back({x, other, 3});
      mesh.points.push_back({0, static_cast<double>(found), 0});
      ++found;
    }
  }
  for (std::int32_t i = 0; i < 150; i += 3)
  {
    mesh.triangles.push_back({i, i + 1, i + 2});
  }
  EXPECT_EQ(clean(mesh).vertices.size(), 101u);
  expectTheSameForAllExecutors({mesh.view()}, 205);
}

TEST(Prepare, GivesNoFieldWhereverItIsInterrupted)
{
  const Mesh mesh = loosened(openCube());
  const Cloud cloud = sphereCloud(100);
  int runs = 0;
  for (bool interrupted = true; interrupted; ++runs)
  {
    Interruption executor(runs);
    const bool isBuilt =
      isCompleted([&] { winding::Field::build(Views{mesh.view()}, {}, executor); });
    interrupted = executor.cameToPass();
    EXPECT_NE(isBuilt, interrupted) << runs;
  }
  EXPECT_GT(runs, 5);
  runs = 0;
  for (bool interrupted = true; interrupted; ++runs)
  {
    Interruption executor(runs);
    const std::vector<winding::OrientedPointsView> views = {cloud.view()};
    const bool isBuilt = isCompleted([&] { winding::Field::build(views, {}, executor); });
    interrupted = executor.cameToPass();
    EXPECT_NE(isBuilt, interrupted) << runs;
  }
  EXPECT_GT(runs, 2);
}
