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
  ASSERT_EQ(winding_estimate_normals(
              arrayOf(ball.points), nullptr, nullptr, normals.data(), areas.data(), nullptr),
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
