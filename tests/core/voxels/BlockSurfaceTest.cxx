// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/BlockSurface.h"

#include "base/Executor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <utility>

namespace
{

using namespace winding;

VoxelSides<unsigned char> randomSides(std::mt19937& random)
{
  VoxelSides<unsigned char> sides;
  std::size_t voxels = 1;
  for (int& count : sides.dimensions)
  {
    count = 1 + static_cast<int>(random() % 6);
    voxels *= static_cast<std::size_t>(count);
  }
  for (std::size_t i = 0; i < voxels; ++i)
  {
    sides.labels.push_back(random() % 2);
  }
  return sides;
}

TEST(BlockSurface, ClosesWhatIsInsideWithQuadsThatAreCounted)
{
  std::mt19937 random(7);
  for (int round = 0; round < 50; ++round)
  {
    const VoxelSides<unsigned char> sides = randomSides(random);
    const std::size_t faces = BlockSurface<unsigned char>::countFaces(sides);
    std::vector<std::int64_t> quads(4 * faces, -1);
    std::vector<std::array<int, 3>> corners;
    SerialExecutor executor;
    BlockSurface<unsigned char> surface(sides, false, faces);
    surface.build(
      quads.data(),
      [&](int i, int j, int k) {
        corners.push_back({i, j, k});
      },
      executor);
    ASSERT_EQ(surface.voxels().size(), faces) << round;
    ASSERT_EQ(std::count(quads.begin(), quads.end(), -1), 0) << round;

    // Six times the volume, by the divergence theorem over both triangles of each quad.
    double volume = 0;
    std::map<std::pair<std::int64_t, std::int64_t>, int> edges;
    for (std::size_t quad = 0; quad < faces; ++quad)
    {
      const std::int64_t* ids = quads.data() + 4 * quad;
      for (int n = 0; n < 4; ++n)
      {
        ++edges[{ids[n], ids[(n + 1) % 4]}];
        --edges[{ids[(n + 1) % 4], ids[n]}];
      }
      for (int n = 1; n < 3; ++n)
      {
        const auto& a = corners[static_cast<std::size_t>(ids[0])];
        const auto& b = corners[static_cast<std::size_t>(ids[n])];
        const auto& c = corners[static_cast<std::size_t>(ids[n + 1])];
        volume += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                  a[2] * (b[0] * c[1] - b[1] * c[0]);
      }
    }
    EXPECT_EQ(volume / 6, std::count(sides.labels.begin(), sides.labels.end(), 1)) << round;
    EXPECT_TRUE(
      std::all_of(edges.begin(), edges.end(), [](const auto& e) { return e.second == 0; }))
      << round;
  }
}

} // namespace
