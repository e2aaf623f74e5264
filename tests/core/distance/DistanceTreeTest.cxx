// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "distance/DistanceTree.h"
#include "distance/NearestKernels.h"

#include "support/Samples.h"
#include "support/Serial.h"
#include "support/Shapes.h"

#include <gtest/gtest.h>

using namespace shapes;

TEST(DistanceTree, TakesAboutTheMemoryThatIsExpected)
{
  const auto shareOf = [](const winding::DistanceTree& tree, bool areTriangles, std::size_t count)
  {
    std::size_t nodes = 1;
    for (std::uint32_t i = 0; i < nodes; ++i)
    {
      nodes += tree.node(i).children;
    }
    const std::size_t item =
      areTriangles ? sizeof(winding::NearTriangle) : sizeof(winding::NearPoint);
    const std::size_t taken = count * (item + sizeof(std::uint32_t)) +
                              nodes * (sizeof(winding::SourceNode) + sizeof(winding::Bounds));
    return static_cast<double>(winding::DistanceTree::bytesFor(areTriangles, count)) /
           static_cast<double>(taken);
  };
  for (const int levels : {4, 5, 6})
  {
    const winding::Surface surface = clean(icosphere(levels));
    const winding::DistanceTree tree(surface, serial);
    const std::size_t count = surface.triangles.size();
    const double share = shareOf(tree, true, count);
    EXPECT_GT(share, 1) << count; // measured: 1.09
    EXPECT_LT(share, 1.2) << count;
  }
  for (const std::size_t count : {3000, 30'000, 100'000})
  {
    const winding::DistanceTree tree(clean(sphereCloud(count)), serial);
    const double share = shareOf(tree, false, count);
    EXPECT_GT(share, 1) << count; // measured: 1.09 to 1.13
    EXPECT_LT(share, 1.2) << count;
  }
}
