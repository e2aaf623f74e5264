// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "diagnosis/GridAdvice.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace
{

using winding::Bounds;
using winding::Grid;

Grid unitVoxels()
{
  Grid grid;
  grid.dimensions = {10, 10, 10};
  return grid; // from −0.5 to 9.5
}

std::string faultOf(const Eigen::Vector3d& low, const Eigen::Vector3d& high, bool isEmpty)
{
  const std::optional<winding::Message> advice =
    winding::gridAdvice(unitVoxels(), Bounds(low, high), {isEmpty, false, {}});
  return advice ? advice->fault : "";
}

} // namespace

TEST(GridAdvice, IsNoneForAGridThatShowsItsSource)
{
  EXPECT_EQ(faultOf({1, 1, 1}, {8, 8, 8}, false), "");
  EXPECT_EQ(faultOf({1, 1, 1}, {8, 8, 1}, false), "") << "a sheet";
  EXPECT_EQ(faultOf({1, 1, 1}, {4, 4, 4}, false), "") << "three voxels";
}

TEST(GridAdvice, SaysWhatIsWrongWithAGrid)
{
  EXPECT_EQ(faultOf({9.6, 0, 0}, {12, 3, 3}, true), "the grid misses the source");
  EXPECT_EQ(faultOf({0, -9, 0}, {9, -0.6, 9}, true), "the grid misses the source");
  EXPECT_EQ(faultOf({1, 1, 1}, {8, 8, 3.5}, false), "the source is thinner than three voxels");
  EXPECT_EQ(faultOf({1, 1, 1}, {8, 8, 1}, true), "no sample is inside");
  EXPECT_EQ(faultOf({1, 1, 1}, {8, 8, 8}, true), "no sample is inside");
  const auto thin = winding::gridAdvice(unitVoxels(),
    Bounds(Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(8, 3, 1.0004)), {true, false, {}});
  ASSERT_TRUE(thin);
  EXPECT_EQ(thin->facts, "it has 0.0004 of them along z, and no sample is inside");
}
