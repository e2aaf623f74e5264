// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/WallGrid.h"

#include "level/LevelSurface.h"
#include "source/SourceVolume.h"
#include "support/Serial.h"
#include "support/ShuffledThreads.h"
#include "support/SolidOnGrid.h"

#include <gtest/gtest.h>

namespace
{

using namespace shapes;
using winding::WallGrid;

/// A plate of 1 by 1 and some thickness.
Mesh plate(double thickness)
{
  return cube({0, 0, 0}, {1, 1, thickness});
}

/// Returns the grid of some solids, with a margin of 0.05 around a cube of length 1.
WallGrid gridOver(
  const std::vector<Mesh>& solids, winding::Executor& executor = serial, bool mends = true)
{
  winding::GridRequest request;
  request.bounds = winding::Bounds(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1));
  request.padding = 0.05;
  request.resolution = 0;
  WallGrid grid(request);
  for (const Mesh& solid : solids)
  {
    grid.add(*fieldOf(solid), winding::InsideTest(), mends, executor);
  }
  return grid;
}

} // namespace

TEST(WallGrid, HasOneAndAHalfVoxelsForWalls)
{
  EXPECT_EQ(gridOver({icosphere(3)}).resolution(), 128);
  EXPECT_EQ(gridOver({icosphere(3)}).reason(), "");
  EXPECT_EQ(gridOver({plate(0.02)}).resolution(), 128);
  // 1.1 · 1.5 / 0.008 = 206
  const WallGrid ofThin = gridOver({plate(0.008)});
  EXPECT_EQ(ofThin.resolution(), 210);
  EXPECT_EQ(ofThin.reason(), "resolution " + std::to_string(ofThin.resolution()) +
                               ", since about 98 % of the surface has walls thinner than 1.5 of "
                               "128 voxels");
  EXPECT_EQ(gridOver({plate(0.001)}).resolution(), 286);
  EXPECT_EQ(gridOver({}).resolution(), 128);
  EXPECT_EQ(gridOver({Mesh()}).resolution(), 128);
}

TEST(WallGrid, MeasuresWallsOfMendedSources)
{
  EXPECT_EQ(gridOver({plate(0.008).reversed()}).resolution(), 210);
  EXPECT_EQ(gridOver({plate(0.008).reversed()}, serial, false).resolution(), 128);
}

TEST(WallGrid, LeavesThinWallsThatAreFew)
{
  // A fin of 0.02 has less than a twentieth of the surface.
  const Mesh fin = cube({0.4, 0.4, 1.1}, {0.6, 0.405, 1.2});
  EXPECT_EQ(gridOver({cube().with(fin)}).resolution(), 128);
}

TEST(WallGrid, TakesTheThinnestOfSolidsInAnyOrder)
{
  ShuffledThreads shuffled(1);
  const std::vector<Mesh> solids = {icosphere(3), plate(0.008), plate(0.006), plate(0.02)};
  EXPECT_EQ(gridOver(solids).resolution(), gridOver({plate(0.006)}).resolution());
  EXPECT_EQ(gridOver({solids.rbegin(), solids.rend()}).resolution(), gridOver(solids).resolution());
  EXPECT_EQ(gridOver(solids, shuffled).resolution(), gridOver(solids).resolution());
}

TEST(WallGrid, KeepsTheVolumeOfAPlate)
{
  const Mesh mesh = plate(0.008);
  const double volume = volumeOf(clean(mesh));
  winding::GridRequest request;
  request.bounds = clean(mesh).bounds;
  request.padding = 0.05;
  const auto volumeAt = [&](int resolution)
  {
    request.resolution = resolution;
    const winding::Grid grid = setUpGrid(request);
    const SolidOnGrid solid(mesh, grid, true, serial);
    return volumeOf(surfaceOf(grid, solid.edges, solid.roots, false, serial));
  };
  EXPECT_NEAR(volumeAt(gridOver({mesh}).resolution()) / volume, 1, 0.03);
}
