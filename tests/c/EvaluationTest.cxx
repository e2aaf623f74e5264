// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Calls.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>

namespace
{

using namespace calls;
using shapes::Mesh;
using shapes::Point;

} // namespace

TEST(Grids, AreLaidOutAsWished)
{
  const winding_grid grid = gridAround({0, 0, 0}, {2, 1, 1}, 22);
  EXPECT_EQ(grid.dimensions[0], 22);
  EXPECT_EQ(grid.spacing[0], grid.spacing[1]);
  EXPECT_NEAR(grid.spacing[0], 0.1, 1e-12);

  auto request = with(winding_grid_request_init);
  winding_grid none;
  winding_refusal refusal;
  EXPECT_EQ(winding_lay_out_grid(&request, nullptr, &none, &refusal), WINDING_REFUSED)
    << "no bounds";
  request.resolution = 0;
  EXPECT_EQ(winding_lay_out_grid(&request, nullptr, &none, &refusal), WINDING_REFUSED);
  EXPECT_STREQ(refusal.parameter, "resolution");
  request = with(winding_grid_request_init);
  request.sampling_dimensions[1] = 3;
  EXPECT_EQ(winding_lay_out_grid(&request, nullptr, &none, &refusal), WINDING_REFUSED);
  EXPECT_STREQ(refusal.parameter, "sampling_dimensions");
}

TEST(Grids, HaveTheVoxelsThatWallsAskFor)
{
  const Field plate = fieldOf(shapes::cube({0, 0, 0}, {1, 1, 0.008}));
  const auto request = requestAround({0, 0, 0}, {1, 1, 0.008});
  EXPECT_EQ(request.resolution, 128);
  int32_t resolution = 0;
  char reason[200];
  const auto find = [&](const winding_field* field, int32_t* found, char* why, size_t size)
  {
    return winding_wall_resolution(field, &request, nullptr, 0, nullptr, found, why, size, nullptr);
  };
  EXPECT_EQ(find(plate.get(), &resolution, reason, sizeof reason), WINDING_OK);
  EXPECT_EQ(resolution, 210); // 1.1 · 1.5 / 0.008 = 206
  EXPECT_EQ(std::string(reason).rfind("resolution 210, since about 9", 0), 0u) << reason;
  EXPECT_EQ(find(plate.get(), &resolution, reason, 4), WINDING_OK);
  EXPECT_STREQ(reason, "res");
  EXPECT_EQ(find(plate.get(), &resolution, nullptr, 0), WINDING_OK);
  EXPECT_EQ(find(nullptr, &resolution, reason, sizeof reason), WINDING_MISUSED);
  EXPECT_EQ(find(plate.get(), nullptr, reason, sizeof reason), WINDING_MISUSED);
}

TEST(Grids, HaveTheSameBitsInParts)
{
  const Mesh soup = shapes::triangleSoup(500, 3901);
  const Field field = fieldOf(soup);
  const winding_grid grid = gridAround({-2, -2, -2}, {2, 2, 2}, 24);
  std::vector<float> whole(sizeOf(grid)), part(whole.size());
  std::vector<std::uint8_t> inside(whole.size());
  auto values = with(winding_values_init);
  values.winding = whole.data();
  values.inside = inside.data();
  auto run = with(winding_run_init);
  run.number_of_threads = 1;
  ASSERT_EQ(winding_evaluate_grid(field.get(), &grid, nullptr, nullptr, &values, &run, nullptr),
    WINDING_OK);
  EXPECT_EQ(values.inside_count, std::count(inside.begin(), inside.end(), 1));
  std::size_t before = 0;
  for (const auto& [first, last] : {std::pair(0, 4), {5, 5}, {6, 23}})
  {
    const int32_t extent[6] = {0, 23, 0, 23, first, last};
    auto some = with(winding_values_init);
    some.winding = part.data() + before;
    ASSERT_EQ(winding_evaluate_grid(field.get(), &grid, extent, nullptr, &some, nullptr, nullptr),
      WINDING_OK);
    before += static_cast<std::size_t>(24 * 24 * (last - first + 1));
  }
  EXPECT_EQ(whole, part);

  for (const std::array<int32_t, 6>& wrong :
    {std::array<int32_t, 6>{0, 24, 0, 23, 0, 23}, {-1, 3, 0, 3, 0, 3}, {0, 3, 4, 3, 0, 3}})
  {
    EXPECT_EQ(
      winding_evaluate_grid(field.get(), &grid, wrong.data(), nullptr, &values, nullptr, nullptr),
      WINDING_MISUSED);
  }
}

TEST(Grids, HaveCoverageOfVoxels)
{
  const Field field = fieldOf(shapes::cube());
  winding_grid grid = {{-0.25, 0, 0}, {0.5, 0.5, 0.5}, {5, 3, 3}};
  std::vector<float> shares(45);
  std::vector<std::uint8_t> any(45);
  auto values = with(winding_values_init);
  values.fractions = shares.data();
  values.coverage = WINDING_COVERAGE_FRACTION;
  ASSERT_EQ(winding_evaluate_grid(field.get(), &grid, nullptr, nullptr, &values, nullptr, nullptr),
    WINDING_OK);
  EXPECT_EQ(shares[15 + 5 + 1], 1.0F);
  EXPECT_EQ(shares[5 + 1], 0.5F);
  EXPECT_EQ(shares[0], 0.0F);
  values = with(winding_values_init);
  values.coverage = WINDING_COVERAGE_ANY;
  values.inside = any.data();
  ASSERT_EQ(winding_evaluate_grid(field.get(), &grid, nullptr, nullptr, &values, nullptr, nullptr),
    WINDING_OK);
  EXPECT_EQ(values.inside_count, 36) << "all but the last layer along x touch it";
  values.fractions = shares.data();
  EXPECT_EQ(winding_evaluate_grid(field.get(), &grid, nullptr, nullptr, &values, nullptr, nullptr),
    WINDING_MISUSED);
}

TEST(Grids, HaveTheShareThatSeveralFieldsCover)
{
  // Two slabs cover the lower and the middle half of the voxels.
  const auto slab = [](double from, double to)
  {
    return fieldOf(shapes::cube().mapped(
      [=](const Point& p) { return Point(p.x(), p.y(), from + (to - from) * p.z()); }));
  };
  const winding_grid grid = {{0.25, 0.25, 0.5}, {0.5, 0.5, 1}, {2, 2, 1}};
  std::vector<float> shares(4);
  for (const int32_t samples : {4, 8})
  {
    std::vector<std::uint64_t> bits(samples == 4 ? 4 : 32, 0);
    auto values = with(winding_values_init);
    values.fractions = shares.data();
    values.coverage = WINDING_COVERAGE_FRACTION;
    values.coverage_samples = samples;
    values.united = bits.data();
    const auto evaluate = [&](const Field& field)
    {
      return winding_evaluate_grid(field.get(), &grid, nullptr, nullptr, &values, nullptr, nullptr);
    };
    ASSERT_EQ(evaluate(slab(0, 0.5)), WINDING_OK);
    EXPECT_EQ(shares, std::vector<float>(4, 0.5F));
    ASSERT_EQ(evaluate(slab(0.25, 0.75)), WINDING_OK);
    EXPECT_EQ(shares, std::vector<float>(4, 0.75F));
    values.united = nullptr;
    ASSERT_EQ(evaluate(slab(0.25, 0.75)), WINDING_OK);
    EXPECT_EQ(shares, std::vector<float>(4, 0.5F)) << "of one field alone";
  }

  std::uint64_t word = 0;
  auto values = with(winding_values_init);
  values.united = &word;
  const Field field = slab(0, 1);
  EXPECT_EQ(winding_evaluate_grid(field.get(), &grid, nullptr, nullptr, &values, nullptr, nullptr),
    WINDING_MISUSED)
    << "without fractions";
  const double point[3] = {0, 0, 0};
  EXPECT_EQ(winding_evaluate_points(
              field.get(), {point, 1, 0, WINDING_FLOAT64}, nullptr, &values, nullptr, nullptr),
    WINDING_MISUSED);
}

TEST(Grids, SayWhatMakesTheResultDiffer)
{
  const auto warningsOf = [](const Mesh& mesh, const winding_grid& grid, double threshold)
  {
    Warnings told;
    const Field field = fieldOf(mesh, nullptr, &told.run);
    std::vector<std::uint8_t> inside(sizeOf(grid));
    auto values = with(winding_values_init);
    values.inside = inside.data();
    auto rule = with(winding_rule_init);
    rule.winding_threshold = threshold;
    EXPECT_EQ(
      winding_evaluate_grid(field.get(), &grid, nullptr, &rule, &values, &told.run, nullptr),
      WINDING_OK);
    EXPECT_LE(told.texts.size(), 1u);
    return told.texts.empty() ? "" : told.texts[0];
  };
  const Mesh ball = shapes::icosphere(3);
  const winding_grid around = gridAround({-1, -1, -1}, {1, 1, 1}, 20);
  EXPECT_EQ(warningsOf(ball, around, 0.5), "");
  EXPECT_NE(warningsOf(ball.reversed(), around, 0.5)
              .find("look inward: use inside_rule = WINDING_INSIDE_RULE_ABSOLUTE"),
    std::string::npos)
    << warningsOf(ball.reversed(), around, 0.5);
  EXPECT_NE(warningsOf(ball, around, 5).find("(winding_threshold)"), std::string::npos);
  EXPECT_NE(
    warningsOf(ball, gridAround({7, 7, 7}, {8, 8, 8}, 4), 0.5).find("misses"), std::string::npos);
  const Mesh shell = ball.with(ball.reversed().scaled(0.98));
  EXPECT_NE(warningsOf(shell, around, 0.5).find("thinner than a voxel"), std::string::npos);
}

TEST(SamplePoints, HaveValuesDistancesAndGradients)
{
  const Field field = fieldOf(shapes::openCube());
  const std::vector<Point> points = {{0.5, 0.5, 0.5}, {3, 0.5, 0.5},
    {std::numeric_limits<double>::infinity(), 0, 0}, {std::nan(""), 0, 0}};
  std::vector<double> w(4), distances(4), gradients(12);
  std::vector<std::uint8_t> inside(4);
  auto values = with(winding_values_init);
  values.type = WINDING_FLOAT64;
  values.winding = w.data();
  values.inside = inside.data();
  values.distance = distances.data();
  values.gradient = gradients.data();
  ASSERT_EQ(
    winding_evaluate_points(field.get(), arrayOf(points), nullptr, &values, nullptr, nullptr),
    WINDING_OK);
  EXPECT_NEAR(w[0], 5.0 / 6, 1e-12);
  EXPECT_EQ(inside, (std::vector<std::uint8_t>{1, 0, 0, 0}));
  EXPECT_EQ(values.inside_count, 1);
  EXPECT_EQ(distances[0], -0.5);
  EXPECT_EQ(distances[1], 2);
  EXPECT_LT(gradients[2], 0) << "w grows away from the opening";
  EXPECT_TRUE(std::isnan(gradients[9]));

  values.distance_limit = 0.75;
  ASSERT_EQ(
    winding_evaluate_points(field.get(), arrayOf(points), nullptr, &values, nullptr, nullptr),
    WINDING_OK);
  EXPECT_EQ(distances[1], 0.75);
}

TEST(Cells, HaveTheShareOfThemThatIsInside)
{
  const Field field = fieldOf(shapes::cube());
  // A hexahedron, a quadrilateral, a tetrahedron, and its polyhedron.
  const std::vector<Point> points = {{0.5, 0.5, 0.75}, {1.5, 0.5, 0.75}, {1.5, 1.5, 0.75},
    {0.5, 1.5, 0.75}, {0.5, 0.5, 1.75}, {1.5, 0.5, 1.75}, {1.5, 1.5, 1.75}, {0.5, 1.5, 1.75},
    {0.5, 0.5, std::nan("")}};
  std::vector<std::uint8_t> types = {12, 9, 10, 42, 10, 42};
  std::vector<std::int32_t> corners = {0, 1, 2, 3, 4, 5, 6, 7, 0, 0, 0, 1, 0, 1, 3, 4, //
    4, 3, 0, 3, 1, 3, 0, 1, 4, 3, 1, 3, 4, 3, 3, 0, 4, 0, 1, 3, 8};
  std::vector<std::int64_t> offsets = {0, 8, 12, 16, 33, 37, 37};
  const auto cells = [&]() -> winding_cells
  {
    return {{types.data(), static_cast<int64_t>(types.size()), 0, WINDING_UINT8},
      {corners.data(), static_cast<int64_t>(corners.size()), 0, WINDING_INT32},
      {offsets.data(), static_cast<int64_t>(offsets.size()), 0, WINDING_INT64}};
  };
  std::vector<float> fractions(types.size());
  std::string warnings;
  auto run = with(winding_run_init);
  run.user = &warnings;
  run.warn = [](const char* text, void* user)
  {
    *static_cast<std::string*>(user) += text;
  };
  winding_cells given = cells();
  ASSERT_EQ(winding_cell_fractions(
              field.get(), arrayOf(points), &given, nullptr, fractions.data(), &run, nullptr),
    WINDING_OK);
  EXPECT_FLOAT_EQ(fractions[0], 0.0625F);
  EXPECT_EQ(fractions[1], 1) << "its middle is inside";
  // A square of ¼ less a corner of z²/2, from z = 0 to ¼, times 6.
  EXPECT_NEAR(fractions[2], 0.359375F, 1e-6F);
  EXPECT_EQ(fractions[3], fractions[2]);
  EXPECT_TRUE(std::isnan(fractions[4]));
  EXPECT_TRUE(std::isnan(fractions[5]));
  EXPECT_NE(warnings.find("1 of 6 cells have no volume"), std::string::npos) << warnings;
  EXPECT_NE(warnings.find("2 of 6 cells are empty or not finite"), std::string::npos) << warnings;

  const auto expectRefused = [&](const std::string& words)
  {
    winding_refusal refusal = {};
    given = cells();
    EXPECT_EQ(winding_cell_fractions(
                field.get(), arrayOf(points), &given, nullptr, fractions.data(), nullptr, &refusal),
      WINDING_REFUSED);
    EXPECT_NE(std::string(refusal.text).find(words), std::string::npos) << refusal.text;
  };
  corners[12] = 9;
  expectRefused("cell 2 of the mesh refers to point 9 of 9");
  corners[12] = 0;
  corners[18] = -1;
  expectRefused("cell 3 of the mesh refers to point -1 of 9");
  corners[18] = 0;
  corners[16] = 5;
  expectRefused("cell 3 of the mesh is a polyhedron with another number of faces");
  corners[17] = 99;
  expectRefused("cell 3 of the mesh is a polyhedron with a face that does not end");
  types[2] = 14;
  expectRefused("cell 2 of the mesh has 4 points, which a cell of type 14 cannot have");
  types[2] = 10;
  corners[16] = 4;
  corners[17] = 3;
  types[0] = 41;
  expectRefused("cell 0 of the mesh is a set of points: give its faces, as a polyhedron");
  types[0] = 99;
  expectRefused("cell 0 of the mesh has unknown type 99");
}

TEST(SamplePoints, MayBeAskedForByManyThreadsAtOnce)
{
  const Mesh soup = shapes::triangleSoup(2000, 3902);
  const Field field = fieldOf(soup);
  const std::vector<Point> points = shapes::pointsNear(soup, 500, 0.1, 3903);
  const auto evaluate = [&]
  {
    std::vector<double> w(points.size());
    auto values = with(winding_values_init);
    values.type = WINDING_FLOAT64;
    values.winding = w.data();
    EXPECT_EQ(
      winding_evaluate_points(field.get(), arrayOf(points), nullptr, &values, nullptr, nullptr),
      WINDING_OK);
    return w;
  };
  const std::vector<double> expected = evaluate();
  std::vector<std::thread> threads;
  std::atomic<int> different{0};
  for (int i = 0; i < 16; ++i)
  {
    threads.emplace_back([&] { different += evaluate() != expected; });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(different, 0);
}
