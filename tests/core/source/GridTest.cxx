// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "source/Grid.h"

#include "base/Bounds.h"
#include "support/Samples.h"

#include "support/Named.h"
#include "support/Refusals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace
{

using shapes::Point;
using winding::Bounds;
using winding::Grid;
using winding::GridRequest;
using winding::Parameter;
using winding::setUpGrid;

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

GridRequest over(const Point& low, const Point& high)
{
  GridRequest request;
  request.bounds = Bounds(low, high);
  return request;
}

GridRequest overSome()
{
  return over({1, 2, 3}, {5, 4, 4});
}

/// Expects a refusal in one line that mentions a number or the name of the culprit, and names a
/// parameter, if one is given.
void expectRefused(
  const GridRequest& request, const std::string& mention, std::optional<Parameter> parameter = {})
{
  shapes::expectRefused([&] { setUpGrid(request); }, mention, parameter);
}

} // namespace

TEST(SetUpGrid, MakesCubicVoxelsOfTheResolutionAlongTheLongestSide)
{
  GridRequest request = overSome();
  request.resolution = 8;
  const Grid grid = setUpGrid(request);
  EXPECT_EQ(grid.dimensions, Eigen::Vector3i(8, 4, 2));
  EXPECT_EQ(grid.spacing, Point(0.5, 0.5, 0.5));
  EXPECT_EQ(grid.firstSample, Point(1.25, 2.25, 3.25));
  EXPECT_EQ(grid.corner(), Point(1, 2, 3));
  EXPECT_EQ(grid.sample(7, 3, 1), Point(4.75, 3.75, 3.75));
}

TEST(SetUpGrid, PadsByAFractionOfTheLongestSideOnEachSide)
{
  GridRequest request = overSome();
  request.resolution = 12;
  request.padding = 0.25;
  const Grid grid = setUpGrid(request);
  EXPECT_EQ(grid.dimensions, Eigen::Vector3i(12, 8, 6));
  EXPECT_EQ(grid.corner(), Point(0, 1, 2));
}

TEST(SetUpGrid, PadsByAVoxelAtLeast)
{
  GridRequest request = overSome();
  request.padding = 0.05;
  request.resolution = 10;
  Grid grid = setUpGrid(request);
  EXPECT_EQ(grid.dimensions, Eigen::Vector3i(10, 6, 4));
  EXPECT_EQ(grid.spacing, Point(0.5, 0.5, 0.5));
  EXPECT_EQ(grid.corner(), Point(0.5, 1.5, 2.5));
  request.resolution = 22; // from here on the padding is a voxel or more
  EXPECT_EQ(setUpGrid(request).spacing[0], (4 + 2 * (4 * 0.05)) / 22);
  request.resolution = 2; // one around each side would leave none
  EXPECT_EQ(setUpGrid(request).spacing[0], (4 + 2 * (4 * 0.05)) / 2);
  request.voxelSize = 1;
  grid = setUpGrid(request);
  EXPECT_EQ(grid.dimensions, Eigen::Vector3i(6, 4, 3));
  EXPECT_EQ(grid.corner(), Point(0, 1, 2));
  request.dimensions = {4, 6, 40};
  grid = setUpGrid(request);
  EXPECT_EQ(grid.corner(), Point(-1, 1.5, 2.95));
  EXPECT_EQ(grid.spacing.head<2>(), Point(2, 0.5, 0).head<2>());
  request.isCubic = true;
  EXPECT_EQ(setUpGrid(request).corner(), Point(-1, -3, -36.5));
}

TEST(SetUpGrid, TakesTheVoxelSizeInPlaceOfTheResolution)
{
  GridRequest request = overSome();
  request.voxelSize = 0.25;
  request.resolution = 0;
  const Grid grid = setUpGrid(request);
  EXPECT_EQ(grid.dimensions, Eigen::Vector3i(16, 8, 4));
  EXPECT_EQ(grid.spacing, Point(0.25, 0.25, 0.25));
}

TEST(SetUpGrid, ReachesOverTheBoundsByTheSameOnBothSidesAndLessThanAVoxelInAll)
{
  SCOPED_TRACE("seed 81");
  shapes::Random random(81);
  for (int i = 0; i < 1000; ++i)
  {
    const Point low = random.point(-10, 10);
    GridRequest request = over(low, low + random.point(0.01, 3));
    request.resolution = 1 + static_cast<int>(random(0, 100));
    request.padding = random(0, 1);
    const Grid grid = setUpGrid(request);
    const double share = request.resolution > 2
                           ? std::max(request.padding, 1. / (request.resolution - 2))
                           : request.padding;
    const Point margin = Point::Constant(share * request.bounds.sizes().maxCoeff());
    const Point before = request.bounds.min() - margin - grid.corner();
    const Point last =
      grid.sample(grid.dimensions[0] - 1, grid.dimensions[1] - 1, grid.dimensions[2] - 1);
    const Point after = last + 0.5 * grid.spacing - request.bounds.max() - margin;
    // Rounding includes the 1e-12 of a side that countVoxels() forgives.
    const double rounding = 1e-11 * grid.spacing[0];
    EXPECT_EQ(grid.dimensions.maxCoeff(), request.resolution);
    EXPECT_EQ(grid.spacing.minCoeff(), grid.spacing.maxCoeff());
    EXPECT_LT((before - after).cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_GT(before.minCoeff(), -rounding - 1e-13);
    EXPECT_LT((before + after).maxCoeff(), grid.spacing[0]);
  }
}

TEST(SetUpGrid, PadsEachAxisByItsOwnLengthWithGivenDimensions)
{
  GridRequest request = overSome();
  request.dimensions = {6, 6, 6};
  request.padding = 0.25;
  Grid grid = setUpGrid(request);
  EXPECT_EQ(grid.corner(), Point(0, 1.5, 2.75));
  EXPECT_EQ(grid.spacing, Point(1, 0.5, 0.25));
  request.bounds = over({1, 2, 3}, {5, 4, 3}).bounds; // flat
  grid = setUpGrid(request);
  EXPECT_LT((grid.corner() - Point(0, 1.5, 2)).norm(), 1e-15);
  request.isCubic = true;
  EXPECT_EQ(setUpGrid(request).spacing, Point(1, 1, 1));
}

TEST(SetUpGrid, GainsNoVoxelByRounding)
{
  GridRequest request = over({0, 0, 0}, {0.3, 0.7, 2.1});
  request.voxelSize = 0.1;
  EXPECT_EQ(setUpGrid(request).dimensions, Eigen::Vector3i(3, 7, 21));
}

TEST(SetUpGrid, FillsTheBoundsExactlyWithGivenDimensions)
{
  GridRequest request = overSome();
  request.dimensions = {2, 4, 1};
  const Grid grid = setUpGrid(request);
  EXPECT_EQ(grid.dimensions, request.dimensions);
  EXPECT_EQ(grid.spacing, Point(2, 0.5, 1));
  EXPECT_EQ(grid.corner(), Point(1, 2, 3));
}

TEST(SetUpGrid, GivesFlatBoundsOneLayerOfVoxelsAroundThem)
{
  GridRequest request = over({0, 0, 5}, {4, 4, 5});
  request.resolution = 4;
  const Grid grid = setUpGrid(request);
  EXPECT_EQ(grid.dimensions, Eigen::Vector3i(4, 4, 1));
  EXPECT_EQ(grid.firstSample[2], 5);
}

TEST(SetUpGrid, ScalesWithTheUnitOfLength)
{
  for (const double scale : {0x1p-330, 0x1p-100, 0x1p100, 0x1p330})
  {
    const Grid unit = setUpGrid(overSome());
    const Grid grid = setUpGrid(over(scale * Point(1, 2, 3), scale * Point(5, 4, 4)));
    EXPECT_EQ(grid.dimensions, unit.dimensions);
    EXPECT_EQ(grid.firstSample, scale * unit.firstSample);
    EXPECT_EQ(grid.spacing, scale * unit.spacing);
  }
}

TEST(SetUpGrid, RefusesBoundsThatAreNone)
{
  constexpr Parameter bounds = Parameter::samplingBounds;
  expectRefused(GridRequest(), "bounds", bounds);
  expectRefused(over({0, 3, 0}, {1, 2, 1}), "3 2", bounds);
  expectRefused(over({0, 0, notANumber}, {1, 1, 1}), "nan", bounds);
  expectRefused(over({0, 0, 0}, {1, notANumber, 1}), "nan", bounds);
  expectRefused(over({0, 0, 0}, {1, infinity, 1}), "inf", bounds);
  expectRefused(over({-1.5e308, 0, 0}, {1.5e308, 1, 1}), "1.5e+308", bounds);
  expectRefused(over({1, 1, 1}, {1, 1, 1}), "single point", bounds);
}

TEST(SetUpGrid, RefusesSizesThatMakeNoGrid)
{
  const auto refuse = [](Parameter parameter, const std::string& mention, const auto& change)
  {
    GridRequest request = overSome();
    change(request);
    expectRefused(request, mention, parameter);
  };
  constexpr Parameter resolution = Parameter::resolution;
  constexpr Parameter voxelSize = Parameter::voxelSize;
  constexpr Parameter padding = Parameter::padding;
  constexpr Parameter dimensions = Parameter::samplingDimensions;
  refuse(resolution, "is 0;", [](GridRequest& r) { r.resolution = 0; });
  refuse(resolution, "is -3;", [](GridRequest& r) { r.resolution = -3; });
  refuse(voxelSize, "is -1;", [](GridRequest& r) { r.voxelSize = -1; });
  refuse(voxelSize, "is nan;", [](GridRequest& r) { r.voxelSize = notANumber; });
  refuse(voxelSize, "is inf;", [](GridRequest& r) { r.voxelSize = infinity; });
  refuse(padding, "is -0.1;", [](GridRequest& r) { r.padding = -0.1; });
  refuse(padding, "is nan;", [](GridRequest& r) { r.padding = notANumber; });
  refuse(padding, "is inf;", [](GridRequest& r) { r.padding = infinity; });
  refuse(dimensions, "4 0 4", [](GridRequest& r) { r.dimensions = {4, 0, 4}; });
  refuse(dimensions, "at most 2147483646",
    [](GridRequest& r) {
      r.dimensions = {1, 1, 2147483647};
    });
  refuse(dimensions, "4 -1 4", [](GridRequest& r) { r.dimensions = {4, -1, 4}; });
  refuse(voxelSize, "1e-300", [](GridRequest& r) { r.voxelSize = 1e-300; });
  refuse(voxelSize, "2147483646", [](GridRequest& r) { r.voxelSize = 1e-9; });
  refuse(voxelSize, "2000000000",
    [](GridRequest& r) {
      r.dimensions = {2000000000, 2000000000, 3};
    });
  refuse(padding, "0",
    [](GridRequest& r) {
      r = over({0, 0, 5}, {4, 4, 5}), r.dimensions = {4, 4, 4};
    });
}

TEST(SetUpGrid, RefusesVoxelsThatCannotBeToldApart)
{
  GridRequest request = over({1e17, 0, 0}, {1e17 + 64, 64, 64});
  request.resolution = 64;
  expectRefused(request, "told apart", Parameter::voxelSize);
}

TEST(SampleCount, IsTheProductOfTheRangesAndZeroForEmptyOnes)
{
  EXPECT_EQ(winding::sampleCount({0, 3, 0, 4, 0, 5}), 4u * 5u * 6u);
  EXPECT_EQ(winding::sampleCount({-2, 3, 7, 7, 5, 6}), 6u * 1u * 2u);
  EXPECT_EQ(winding::sampleCount({0, -1, 0, 4, 0, 5}), 0u);
  EXPECT_EQ(winding::sampleCount({0, -1, 0, -1, 0, -1}), 0u);
  EXPECT_EQ(winding::sampleCount({0, 5, 9, 3, 0, 5}), 0u);
  EXPECT_EQ(winding::sampleCount({0, 99999, 0, 99999, 0, 99999}), 1000000000000000u);
}

TEST(SampleIndex, RunsThroughAnExtentWithXFastest)
{
  const winding::Extent extent = {-1, 2, 5, 6, 3, 5};
  Grid grid;
  grid.firstSample = {0.1, -7, 1e3};
  grid.spacing = {0.3, 0.7, 1e-3};
  grid.dimensions = {3, 7, 6};
  std::size_t n = 0;
  for (int k = 3; k <= 5; ++k)
  {
    for (int j = 5; j <= 6; ++j)
    {
      for (int i = -1; i <= 2; ++i)
      {
        const Eigen::Vector3i index(i, j, k);
        EXPECT_EQ(winding::sampleNumber(extent, index), n);
        EXPECT_EQ(grid.sample(extent, n), grid.sample(i, j, k));
        EXPECT_EQ(winding::sampleIndex(extent, n++), index);
      }
    }
  }
  EXPECT_EQ(n, winding::sampleCount(extent));
  EXPECT_EQ(grid.sample(0), grid.sample(0, 0, 0));
  EXPECT_EQ(grid.sample(3 * 7 * 4 + 3 * 5 + 2), grid.sample(2, 5, 4));
}

TEST(Grid, HasItsWholeExtentFromZeroToOneLessThanItsDimensions)
{
  Grid grid;
  grid.dimensions = {4, 5, 6};
  EXPECT_EQ(grid.wholeExtent(), (winding::Extent{0, 3, 0, 4, 0, 5}));
}

TEST(SetUpGrid, RefusesGridsWhoseLengthsLeaveTheRange)
{
  GridRequest request = over({-1e101, -1, -1}, {1e101, 1, 1});
  EXPECT_EQ(setUpGrid(request).dimensions, Eigen::Vector3i(128, 1, 1));
  request = over({-1.01e102, -1, -1}, {0, 1, 1});
  expectRefused(request, "reaches to -1.01e+102");
  request = over({0, -1, -1}, {1.7e308, 1, 1});
  expectRefused(request, "reaches to 1.7e+308");
  request = over({0, 0, 0}, {1, 1, 1});
  request.voxelSize = 1e103;
  expectRefused(request, "reaches to -5e+102");
  request.voxelSize = 0;
  request.padding = 1e200;
  expectRefused(request, "reaches to -1e+200");
  request = over({0, 0, 0}, {1e-100, 1e-100, 1e-100});
  EXPECT_EQ(setUpGrid(request).dimensions, Eigen::Vector3i(128, 128, 128));
  request = over({0, 0, 0}, {1, 1, 1e-110});
  request.dimensions = {2, 2, 2};
  expectRefused(request, "a side of 5e-111", Parameter::voxelSize);
}
