// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/SolidParts.h"

#include "support/Serial.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace
{

using namespace shapes;
using winding::SolidParts;
using winding::Surface;

Mesh operator+(const Mesh& a, const Mesh& b)
{
  return a.with(b);
}

SolidParts partsOf(const Mesh& mesh)
{
  return winding::solidPartsOf(clean(mesh), {}, serial);
}

/// The number of triangles of each solid.
std::vector<std::size_t> sizesOf(const Mesh& mesh)
{
  const SolidParts parts = partsOf(mesh);
  std::vector<std::size_t> sizes(parts.count);
  for (const std::int32_t solid : parts.ofTriangle)
  {
    ++sizes.at(static_cast<std::size_t>(solid));
  }
  return sizes;
}

using Sizes = std::vector<std::size_t>;

TEST(SolidParts, AreComponentsByTheirVolumes)
{
  const Mesh mesh = ball({0, 0, 0}, 1, 3) + ball({4, 0, 0}, 3, 1) + ball({9, 0, 0}, 2, 2);
  EXPECT_EQ(sizesOf(mesh), (Sizes{80, 320, 1280}));
  EXPECT_EQ(sizesOf(Mesh()), Sizes());
}

TEST(SolidParts, OfEqualOnesTheLowestComesFirst)
{
  // Volumes of copies differ by rounding.
  const Mesh mesh = ball({3, 0.7, 0}, 1) + ball({-3, 0, 0.1}, 1) + ball({0, 1e-3, 0}, 1);
  const SolidParts parts = partsOf(mesh);
  EXPECT_EQ(parts.count, 3u);
  EXPECT_EQ(parts.ofTriangle.front(), 2);
  EXPECT_EQ(parts.ofTriangle[320], 0);
  EXPECT_EQ(parts.ofTriangle.back(), 1);
}

TEST(SolidParts, WallsOfCavitiesBelongToWhatIsAroundThem)
{
  const Mesh shell = ball({0, 0, 0}, 4, 3), wall = ball({0, 0, 0}, 3).reversed();
  const Mesh core = ball({0, 0, 0}, 2, 1), other = ball({10, 0, 0}, 1, 0);
  const Mesh hole = ball({0, 0, 0}, 1, 0).reversed();
  EXPECT_EQ(sizesOf(wall + core + shell + other), (Sizes{1280 + 320, 80, 20}));
  EXPECT_EQ(sizesOf(hole + wall + core + shell + other), (Sizes{1280 + 320, 80 + 20, 20}));
  // A solid that lies in another and looks outward is one of its own, and so is one that looks
  // inward and lies in nothing.
  EXPECT_EQ(sizesOf(shell + core), (Sizes{1280, 80}));
  EXPECT_EQ(sizesOf(core + hole.moved({9, 0, 0})), (Sizes{80, 20}));
}

TEST(SolidParts, DoNotDependOnTheOrderOfTrianglesOrThreads)
{
  const Mesh mesh =
    ball({0, 0, 0}, 2) + ball({0, 0, 0}, 1).reversed() + ball({5, 0, 0}, 1) + ball({0, 5, 0}, 1, 1);
  const Surface surface = clean(mesh);
  const SolidParts expected = winding::solidPartsOf(surface, {}, serial);
  std::map<winding::Triangle, std::int32_t> solids;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    solids[surface.triangles[i]] = expected.ofTriangle[i];
  }
  std::mt19937 random(3);
  for (int round = 0; round < 5; ++round)
  {
    Surface shuffled = surface;
    std::shuffle(shuffled.triangles.begin(), shuffled.triangles.end(), random);
    ShuffledThreads threads(static_cast<unsigned>(round));
    const SolidParts parts = winding::solidPartsOf(shuffled, {}, threads);
    ASSERT_EQ(parts.count, 3u);
    for (std::size_t i = 0; i < shuffled.triangles.size(); ++i)
    {
      ASSERT_EQ(parts.ofTriangle[i], solids[shuffled.triangles[i]]);
    }
  }
}

} // namespace
