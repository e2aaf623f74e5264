// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Calls.h"

#include <cmath>
#include <numeric>

namespace
{

using namespace calls;
using shapes::Mesh;
using shapes::Point;

} // namespace

TEST(EstimatedNormals, PointOutward)
{
  Mesh ball = shapes::icosphere(4);
  ball.points[9][0] = std::nan("");
  const std::size_t count = ball.points.size();
  std::vector<float> normals(3 * count, 9);
  std::vector<double> areas(count, 9);
  auto estimate = with(winding_estimate_init);
  ASSERT_EQ(winding_estimate_normals(arrayOf(ball.points), nullptr, nullptr, normals.data(),
              areas.data(), &estimate, nullptr),
    WINDING_OK);
  for (std::size_t i = 0; i < count; ++i)
  {
    const Point normal(normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]);
    if (i == 9)
    {
      EXPECT_EQ(normal, Point(0, 0, 0));
      EXPECT_TRUE(std::isnan(areas[i]));
    }
    else
    {
      EXPECT_GT(normal.dot(ball.points[i]), 0.99);
    }
  }
}

TEST(EstimatedNormals, LookTowardWhereThePointsWereSeenFrom)
{
  const Mesh ball = shapes::icosphere(4);
  std::vector<float> normals(3 * ball.points.size());
  auto options = with(winding_options_init);
  options.toward = "0.2 0 0";
  auto estimate = with(winding_estimate_init);
  Warnings told;
  ASSERT_EQ(winding_estimate_normals(arrayOf(ball.points), &options, &told.run, normals.data(),
              nullptr, &estimate, nullptr),
    WINDING_OK);
  EXPECT_TRUE(told.texts.empty());
  EXPECT_EQ(estimate.normal_estimation, WINDING_NORMAL_ESTIMATION_TOWARD);
  for (std::size_t i = 0; i < ball.points.size(); ++i)
  {
    const Point normal(normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]);
    EXPECT_LT(normal.dot(ball.points[i]), -0.99);
  }
  // Each point may have a place.
  options.toward = nullptr;
  options.look_at_viewpoints = 1;
  for (std::size_t i = 0; i < ball.points.size(); ++i)
  {
    Eigen::Map<Eigen::Vector3f>(normals.data() + 3 * i) = ball.points[i].cast<float>();
  }
  ASSERT_EQ(winding_estimate_normals(
              arrayOf(ball.points), &options, nullptr, normals.data(), nullptr, &estimate, nullptr),
    WINDING_OK);
  EXPECT_EQ(estimate.normal_estimation, WINDING_NORMAL_ESTIMATION_TOWARD);
  for (std::size_t i = 0; i < ball.points.size(); ++i)
  {
    const Point normal(normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]);
    EXPECT_GT(normal.dot(ball.points[i]), 0.99);
  }
  options.toward = "upward";
  winding_refusal refusal;
  EXPECT_EQ(winding_estimate_normals(
              arrayOf(ball.points), &options, nullptr, normals.data(), nullptr, nullptr, &refusal),
    WINDING_REFUSED);
  EXPECT_STREQ(refusal.parameter, "toward");
  options.normal_estimation = WINDING_NORMAL_ESTIMATION_TOWARD;
  EXPECT_EQ(winding_estimate_normals(
              arrayOf(ball.points), &options, nullptr, normals.data(), nullptr, nullptr, &refusal),
    WINDING_REFUSED);
  EXPECT_STREQ(refusal.parameter, "normal_estimation");
}

TEST(NormalsToTurn, AreThoseThatPointInward)
{
  Mesh ball = shapes::icosphere(4);
  std::vector<Point> normals = ball.points;
  std::vector<std::uint8_t> turned(normals.size(), 9), expected(normals.size());
  for (std::size_t i = 0; i < normals.size(); i += 3)
  {
    normals[i] *= -2;
    expected[i] = 1;
  }
  normals[6] = Point(0, 0, 0);
  ball.points[9][0] = std::nan("");
  expected[6] = expected[9] = 0;
  ASSERT_EQ(
    winding_orient_normals(arrayOf(ball.points), arrayOf(normals), nullptr, turned.data(), nullptr),
    WINDING_OK);
  EXPECT_EQ(turned, expected);
  normals.pop_back();
  EXPECT_EQ(
    winding_orient_normals(arrayOf(ball.points), arrayOf(normals), nullptr, turned.data(), nullptr),
    WINDING_MISUSED);
}

TEST(ExaminationOfPoints, CountsAndAdvises)
{
  Mesh ball = shapes::icosphere(4);
  std::vector<Point> normals = ball.points;
  normals[3] = Point(0, 0, 0);
  ball.points.push_back(ball.points[5]);
  normals.push_back(normals[5]);
  auto report = with(winding_cloud_report_init);
  Warnings told;
  ASSERT_EQ(
    winding_examine_points(arrayOf(ball.points), arrayOf(normals), &told.run, &report, nullptr),
    WINDING_OK);
  EXPECT_EQ(report.normals, 1);
  EXPECT_EQ(report.points, 2563);
  EXPECT_EQ(report.duplicates, 1);
  EXPECT_EQ(report.zero_normals, 1);
  EXPECT_GT(report.outward_share, 0.99);
  EXPECT_FALSE(told.texts.empty());
  ASSERT_EQ(
    winding_examine_points(arrayOf(ball.points), {nullptr, 0, 0, 0}, &told.run, &report, nullptr),
    WINDING_OK);
  EXPECT_EQ(report.normals, 0);
  EXPECT_TRUE(std::isnan(report.w_behind));
}

TEST(PointAreas, AddUpToTheSurface)
{
  const Mesh ball = shapes::icosphere(4);
  std::vector<double> areas(ball.points.size());
  ASSERT_EQ(winding_point_areas(
              arrayOf(ball.points), arrayOf(ball.points), nullptr, nullptr, areas.data(), nullptr),
    WINDING_OK);
  EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), 12.566, 0.06); // measured: 12.55
  winding_refusal refusal;
  EXPECT_EQ(winding_point_areas(
              arrayOf(ball.points), {nullptr, 0, 0, 0}, nullptr, nullptr, areas.data(), &refusal),
    WINDING_REFUSED);
  auto options = with(winding_options_init);
  options.number_of_neighbors = 1;
  EXPECT_EQ(winding_point_areas(arrayOf(ball.points), arrayOf(ball.points), &options, nullptr,
              areas.data(), &refusal),
    WINDING_REFUSED);
  EXPECT_STREQ(refusal.parameter, "number_of_neighbors");
}
