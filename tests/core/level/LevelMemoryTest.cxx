// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/LevelMemory.h"
#include "level/LevelEdges.h"
#include "support/Fields.h"
#include "support/Serial.h"
#include "support/Shapes.h"

#include <gtest/gtest.h>

namespace
{

using namespace shapes;
using namespace winding;

Grid gridOf(const Eigen::Vector3d& spacing)
{
  Grid grid;
  grid.spacing = spacing;
  grid.dimensions = (Eigen::Vector3d::Constant(2.2).cwiseQuotient(spacing)).cast<int>();
  grid.firstSample = Eigen::Vector3d::Constant(-1.1) + 0.5 * spacing;
  return grid;
}

struct Counts
{
  double byArea, byCoarseGrid, found;
};

Counts countsOf(const Field& field, const Grid& grid)
{
  constexpr double threshold = 0.5;
  LevelEdges edges(field, grid, {InsideRule::signedThreshold, threshold}, false);
  while (!edges.isDone())
  {
    edges.advance(serial);
  }
  return {levelEdgesByArea(field, grid),
    levelEdgesByCoarseGrid(field, grid, {InsideRule::signedThreshold, threshold}, false, serial),
    static_cast<double>(edges.size())};
}

TEST(LevelMemory, EdgesOfASphereAreForetold)
{
  const Mesh ball = icosphere(4);
  const auto field = fieldOf(ball);
  for (const Eigen::Vector3d& spacing :
    {Eigen::Vector3d(0.01, 0.01, 0.01), Eigen::Vector3d(0.02, 0.01, 0.005)})
  {
    const Counts counts = countsOf(*field, gridOf(spacing));
    EXPECT_NEAR(counts.byArea, counts.found, 0.05 * counts.found) << spacing.transpose();
    EXPECT_NEAR(counts.byCoarseGrid, counts.found, 0.05 * counts.found) << spacing.transpose();
  }
}

TEST(LevelMemory, EdgesOfACloudAreForetold)
{
  const Cloud cloud = sphereCloud(2000);
  const auto field = fieldOf(cloud);
  const Counts counts = countsOf(*field, gridOf(Eigen::Vector3d::Constant(0.02)));
  EXPECT_NEAR(counts.byArea, counts.found, 0.2 * counts.found);
  EXPECT_NEAR(counts.byCoarseGrid, counts.found, 0.2 * counts.found);
}

TEST(LevelMemory, ACoarseGridSeesThatSpheresLieInEachOther)
{
  Mesh onion = icosphere(4);
  for (double scale = 0.9; scale > 0.05; scale -= 0.1)
  {
    onion = onion.with(icosphere(4).scaled(scale));
  }
  const auto field = fieldOf(onion);
  const Counts counts = countsOf(*field, gridOf(Eigen::Vector3d::Constant(0.01)));
  EXPECT_GT(counts.byArea, 3 * counts.found);
  EXPECT_NEAR(counts.byCoarseGrid, counts.found, 0.05 * counts.found);
}

TEST(LevelMemory, BytesGrowWithTheEdges)
{
  const auto closed = fieldOf(icosphere(2));
  const auto open = fieldOf(icosphere(2).part(0, 300));
  EXPECT_EQ(bytesOfLevelSurface(*closed, 0), 0u);
  EXPECT_EQ(bytesOfLevelSurface(*closed, 1e6), 160'000'000u);
  EXPECT_EQ(bytesOfLevelSurface(*open, 1e6), 275'000'000u);
  EXPECT_EQ(bytesOfLevelSurface(*open, 1e30), std::size_t(1e18));
}

} // namespace
