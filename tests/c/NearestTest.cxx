// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Calls.h"

#include "support/NaiveDistance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

/// The places of faces and points that are nearest to samples, as winding_nearest() gives them.

using namespace calls;
using namespace shapes;

namespace
{

struct Found
{
  explicit Found(std::size_t samples)
    : nearest(samples)
    , corners(3 * samples)
    , weights(3 * samples)
  {
  }
  std::vector<std::int64_t> nearest, corners;
  std::vector<double> weights;
};

Found found(const std::vector<Point>& points, const winding_polygons* polygons,
  const winding_options* options, const std::vector<Point>& samples)
{
  Found result(samples.size());
  EXPECT_EQ(
    winding_nearest(arrayOf(points), polygons, options, arrayOf(samples), result.nearest.data(),
      result.corners.data(), result.weights.data(), nullptr, nullptr),
    WINDING_OK);
  return result;
}

/// The place of a sample by its corners and weights.
Point placeOf(const std::vector<Point>& points, const Found& at, std::size_t sample)
{
  Point place = Point::Zero();
  for (std::size_t n = 3 * sample; n < 3 * sample + 3; ++n)
  {
    place += at.weights[n] * points[static_cast<std::size_t>(at.corners[n])];
  }
  return place;
}

} // namespace

TEST(Nearest, FacesAreTheNearestAndWeightsSayWhere)
{
  SCOPED_TRACE("seed 921");
  const Mesh mesh = icosphere(2);
  const winding_polygons polygons = polygonsOf(mesh);
  std::vector<Point> samples = randomPoints(500, -2, 2, 921);
  samples.insert(samples.end(), mesh.points.begin(), mesh.points.end());
  const Found at = found(mesh.points, &polygons, nullptr, samples);
  double worst = 0;
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    const double nearest = naiveDistance(samples[n], mesh);
    worst = std::max(worst, std::abs((samples[n] - placeOf(mesh.points, at, n)).norm() - nearest));
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const auto& triangle = mesh.triangles[static_cast<std::size_t>(at.nearest[n])];
      ASSERT_EQ(at.corners[3 * n + corner], triangle[corner]);
    }
  }
  EXPECT_LT(worst, 1e-14); // measured: 4.5e-16
}

TEST(Nearest, PolygonsHaveTheirOwnNumbers)
{
  // Two quads and a triangle between them, side by side.
  const std::vector<Point> points = {
    {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {3, 0, 0}, {3, 1, 0}, {2, 1, 0}};
  const std::vector<std::int64_t> corners = {0, 1, 2, 3, 1, 4, 2, 4, 5, 6, 7};
  const std::vector<std::int64_t> offsets = {0, 4, 7, 11};
  winding_polygons polygons = {};
  polygons.corners = {corners.data(), 11, 1, WINDING_INT64};
  polygons.offsets = {offsets.data(), 4, 1, WINDING_INT64};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Found at = found(points, &polygons, nullptr,
    {{0.2, 0.7, 5}, {0.7, 0.2, -5}, {1.2, 0.1, 0}, {2.9, 0.1, 1}, {nan, 0, 0}});
  EXPECT_EQ(at.nearest, (std::vector<std::int64_t>{0, 0, 1, 2, -1}));
  EXPECT_EQ(at.corners[12], -1);
  EXPECT_TRUE(std::isnan(at.weights[12]));
}

TEST(Nearest, PointsAloneCountAndImagesStandForThem)
{
  const std::vector<Point> points = {{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 1, 0}};
  const std::vector<Point> samples = {{1.6, 0.2, 0}, {-2.2, 0.9, 0}, {-0.4, 0, 0}};
  EXPECT_EQ(found(points, nullptr, nullptr, samples).nearest, (std::vector<std::int64_t>{1, 0, 0}));
  winding_options options;
  winding_options_init(&options, sizeof options);
  options.mirror = "x=0";
  const Found at = found(points, nullptr, &options, samples);
  EXPECT_EQ(at.nearest, (std::vector<std::int64_t>{1, 2, 0}));
  EXPECT_EQ(at.corners, (std::vector<std::int64_t>{1, 1, 1, 2, 2, 2, 0, 0, 0}));
}

TEST(Nearest, VerticesThatAreWeldedAreOne)
{
  // The second triangle begins 0.01 to the right of the first one, and with it when welded.
  const std::vector<Point> points = {
    {-1, 0.5, 0}, {0, 0, 0}, {0, 1, 0}, {0.01, 0, 0}, {0.01, 1, 0}, {1, 0.5, 0}};
  Mesh mesh{points, {{0, 1, 2}, {3, 5, 4}}};
  const winding_polygons polygons = polygonsOf(mesh);
  auto options = with(winding_options_init);
  for (const double tolerance : {0.0, 0.02})
  {
    options.weld_tolerance = tolerance;
    const Found at = found(points, &polygons, &options, {{0.009, 0.5, 0.1}});
    EXPECT_EQ(at.nearest[0], 1);
    EXPECT_EQ(at.corners, (std::vector<std::int64_t>{3, 5, 4}));
    EXPECT_NEAR(at.weights[1], tolerance > 0 ? 0.009 : 0, 1e-12);
  }
}

TEST(Nearest, NothingIsNearToNothing)
{
  const Found at = found({}, nullptr, nullptr, {{0, 0, 0}});
  EXPECT_EQ(at.nearest.front(), -1);
  std::int64_t none = 0;
  EXPECT_EQ(winding_nearest(arrayOf(std::vector<Point>{{0, 0, 0}}), nullptr, nullptr,
              arrayOf(std::vector<Point>{{0, 0, 0}}), nullptr, nullptr, nullptr, nullptr, nullptr),
    WINDING_MISUSED);
  EXPECT_EQ(winding_nearest(arrayOf(std::vector<Point>{}), nullptr, nullptr,
              arrayOf(std::vector<Point>{}), &none, nullptr, nullptr, nullptr, nullptr),
    WINDING_OK);
}
