// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/Edges.h"

#include "source/Surface.h"
#include "support/Serial.h"
#include "support/Shapes.h"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

namespace
{

using namespace shapes;
using Edge = std::pair<std::int32_t, std::int32_t>;
using Use = std::pair<std::int32_t, int>; ///< triangle and sense

std::map<Edge, std::vector<Use>> usesByDefinition(const winding::Surface& surface)
{
  std::map<Edge, std::vector<Use>> uses;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::int32_t from = surface.triangles[t][i], to = surface.triangles[t][(i + 1) % 3];
      uses[std::minmax(from, to)].emplace_back(static_cast<std::int32_t>(t), from < to ? 1 : -1);
    }
  }
  return uses;
}

std::vector<std::pair<Edge, std::vector<Use>>> usesFound(const winding::Surface& surface)
{
  std::vector<std::pair<Edge, std::vector<Use>>> found;
  winding::EdgeUses(surface, serial)
    .forEachEdge(
      [&](std::int32_t low, const winding::EdgeUse* first, const winding::EdgeUse* last)
      {
        found.push_back({{low, first->high()}, {}});
        for (; first != last; ++first)
        {
          found.back().second.emplace_back(first->triangle(), first->sense());
        }
      });
  return found;
}

} // namespace

TEST(EdgeUses, AreAllUsesOfAllEdgesInOrder)
{
  SCOPED_TRACE("seed 101");
  Random random(101);
  for (int i = 0; i < 300; ++i)
  {
    // Few vertices make edges that many triangles use, both ways, and triangles that occur again.
    const std::uint64_t vertices = 3 + random.bits() % 8;
    winding::Surface surface;
    surface.vertices.resize(vertices);
    while (surface.triangles.size() < 1 + static_cast<std::size_t>(i) / 10)
    {
      winding::Triangle t;
      for (std::int32_t& id : t)
      {
        id = static_cast<std::int32_t>(random.bits() % vertices);
      }
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
      {
        surface.triangles.push_back(t);
      }
    }
    const auto expected = usesByDefinition(surface);
    const auto found = usesFound(surface);
    ASSERT_TRUE(std::equal(found.begin(), found.end(), expected.begin(), expected.end(),
      [](const auto& a, const auto& b) { return a.first == b.first && a.second == b.second; }));
  }
}

TEST(EdgeUses, AreTwoOfOppositeSenseOnClosedManifolds)
{
  const auto found = usesFound(clean(icosphere(2)));
  EXPECT_EQ(found.size(), 480u);
  for (const auto& [edge, uses] : found)
  {
    ASSERT_EQ(uses.size(), 2u);
    EXPECT_EQ(uses[0].second + uses[1].second, 0);
  }
}

TEST(EdgeUses, AreNoneOfAnEmptySurface)
{
  EXPECT_TRUE(usesFound(winding::Surface()).empty());
}
