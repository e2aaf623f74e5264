// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "rays/RowCrossings.h"
#include "source/Surface.h"
#include "support/LatticeChain.h"
#include "support/Serial.h"
#include "support/Shapes.h"
#include "support/ShuffledThreads.h"
#include "surface/Cap.h"

#include <gtest/gtest.h>

#include <vector>

namespace shapes
{

inline winding::Grid gridOf(
  const Point& firstSample, const Point& spacing, const Eigen::Vector3i& dimensions)
{
  winding::Grid grid;
  grid.firstSample = firstSample;
  grid.spacing = spacing;
  grid.dimensions = dimensions;
  return grid;
}

/// The values of all samples. Checks that every row comes once and that its runs cover it in order.
inline std::vector<int> rowValues(const winding::RowCrossings& rows, const winding::Grid& grid,
  const winding::Extent& extent, std::size_t samplesPerBlock, winding::Executor& executor)
{
  std::vector<int> values(winding::sampleCount(extent), -99);
  std::atomic<std::size_t> rowsDone{0}, badRuns{0};
  rows.evaluate(
    grid, extent, samplesPerBlock,
    [&](int j, int k, const std::vector<winding::RowRun>& runs)
    {
      ++rowsDone;
      int next = extent[0];
      for (const winding::RowRun& run : runs)
      {
        badRuns += run.begin != next || run.end <= run.begin;
        next = run.end;
        for (int i = run.begin; i < run.end; ++i)
        {
          values[winding::sampleNumber(extent, i, j, k)] = run.value;
        }
      }
      badRuns += next != extent[1] + 1;
    },
    executor);
  EXPECT_EQ(badRuns, 0u);
  EXPECT_EQ(rowsDone * static_cast<std::size_t>(extent[1] - extent[0] + 1), values.size());
  return values;
}

/// A random lattice chain with its cap.
class ClosedLatticeChain
{
public:
  explicit ClosedLatticeChain(unsigned seed)
    : chain_(randomLatticeChain(seed, 12, 4))
    , cap_(capOf(chain_.surface))
  {
  }
  const winding::Grid& grid() const { return chain_.grid; }
  /// The result is valid while this object lives.
  winding::RowCrossings rows() const
  {
    return {chain_.surface.vertices, chain_.surface.triangles, cap_};
  }

private:
  static winding::TriangleList capOf(const winding::Surface& surface)
  {
    return winding::capOf(
      winding::boundaryLoops(boundaryOf(surface).edges, surface.vertices.size(), serial));
  }

  LatticeChain chain_;
  winding::TriangleList cap_;
};

} // namespace shapes
