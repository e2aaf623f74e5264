// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/Cap.h"

#include "source/Surface.h"
#include "support/LatticeChain.h"
#include "support/Serial.h"
#include "support/Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace
{

using namespace shapes;
using winding::BoundaryLoops;
using winding::Triangle;
using winding::TriangleList;

BoundaryLoops loopsOf(const winding::Surface& surface)
{
  return winding::boundaryLoops(boundaryOf(surface).edges, surface.vertices.size(), serial);
}

bool isClosedBy(winding::Surface surface, const TriangleList& cap)
{
  surface.triangles.insert(surface.triangles.end(), cap.begin(), cap.end());
  return boundaryOf(surface).edges.empty();
}

/// Loops of the given numbers of vertices.
BoundaryLoops polygons(const std::vector<std::int32_t>& sizes)
{
  BoundaryLoops loops;
  for (const std::int32_t corners : sizes)
  {
    std::vector<std::int32_t> loop(static_cast<std::size_t>(corners));
    std::iota(loop.begin(), loop.end(), 0);
    loops.add({loop.data(), loop.data() + loop.size()});
  }
  return loops;
}

} // namespace

TEST(Cap, ClosesEveryRandomChain)
{
  SCOPED_TRACE("seeds 1 … 2000");
  for (unsigned seed = 1; seed <= 2000; ++seed)
  {
    const winding::Surface surface = randomLatticeChain(seed, 40, 3).surface;
    ASSERT_TRUE(isClosedBy(surface, winding::capOf(loopsOf(surface)))) << seed;
  }
}

TEST(Fan, ClosesEveryRandomChain)
{
  SCOPED_TRACE("seeds 1 … 2000");
  for (unsigned seed = 1; seed <= 2000; ++seed)
  {
    winding::Surface surface = randomLatticeChain(seed, 40, 3).surface;
    const auto loops = loopsOf(surface);
    const std::size_t before = surface.vertices.size();
    const auto fan = winding::fanOf(loops, surface.vertices);
    ASSERT_EQ(surface.vertices.size(), before + loops.size());
    ASSERT_TRUE(isClosedBy(surface, fan)) << seed;
  }
}

TEST(Cap, HasTwoTrianglesLessThanALoopHasEdges)
{
  for (std::int32_t n = 3; n < 200; ++n)
  {
    const auto cap = winding::capOf(polygons({n}));
    EXPECT_EQ(cap.size(), static_cast<std::size_t>(n) - 2);
    for (const Triangle& t : cap)
    {
      EXPECT_TRUE(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
    }
  }
  EXPECT_EQ(winding::capOf(polygons({7, 3})).size(), 6u);
  EXPECT_TRUE(winding::capOf(BoundaryLoops()).empty());
}

TEST(Cap, RunsAgainstTheRim)
{
  EXPECT_EQ(winding::capOf(polygons({3})), (TriangleList{{0, 2, 1}}));
}

TEST(Cap, IsGradedFromTheRimToTheMiddle)
{
  // A corner belongs to two triangles of each level at most, and all levels but the first few have
  // few triangles: so the triangles near any sample are about as many as the logarithm of the rim.
  for (const std::int32_t n : {64, 1000, 1024, 4097})
  {
    const auto cap = winding::capOf(polygons({n}));
    std::vector<int> uses(static_cast<std::size_t>(n));
    std::size_t small = 0;
    for (const Triangle& t : cap)
    {
      const auto [low, high] = std::minmax({t[0], t[1], t[2]});
      const std::int32_t span = high - low;
      small += std::min(span, n - span) <= 4;
      for (const std::int32_t corner : t)
      {
        ++uses[corner];
      }
    }
    EXPECT_LE(*std::max_element(uses.begin(), uses.end()), 2 * std::log2(n) + 2) << n;
    EXPECT_GE(small, cap.size() * 7 / 10) << n;
  }
}

TEST(Fan, ClosesLargeLoopsByTrianglesThatAreSmallAtTheRim)
{
  for (const int n : {64, 65, 66, 127, 128, 1000, 4097})
  {
    winding::Surface surface = clean(lathe({{0, 0}, {1, 1}}, n));
    const auto loops = loopsOf(surface);
    ASSERT_EQ(loops.size(), 1u);
    const auto fan = winding::fanOf(loops, surface.vertices);
    EXPECT_EQ(fan.size(), winding::trianglesOfFan(loops[0])) << n;
    EXPECT_TRUE(isClosedBy(surface, fan)) << n;
    std::size_t small = 0;
    for (const Triangle& t : fan)
    {
      small += (surface.vertices[t[0]] - surface.vertices[t[2]]).norm() < 50.0 / n;
    }
    EXPECT_GE(small, n > 200 ? fan.size() * 7 / 10 : 0) << n;
  }
}

TEST(Fan, HasItsApexBesideThePlaneOfTheLoop)
{
  winding::Surface surface = clean(openCube());
  const auto loops = loopsOf(surface);
  const auto fan = winding::fanOf(loops, surface.vertices);
  EXPECT_EQ(fan.size(), 4u);
  // The apex is off the missing face, but no farther than the face is large.
  const Point apex = surface.vertices.back();
  EXPECT_GT(std::abs(apex[2] - 1), 0.1);
  EXPECT_LT((apex - Point(0.5, 0.5, 1)).norm(), std::sqrt(2));
}
