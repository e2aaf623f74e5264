// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Calls.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
#include <string>

// Tests of what the panels of ParaView show.
namespace
{

using namespace calls;
using shapes::Mesh;
using shapes::Point;

} // namespace

TEST(Panels, AreNamedInRefusals)
{
  auto run = with(winding_run_init);
  run.words = WINDING_WORDS_PARAVIEW;
  auto options = with(winding_options_init);
  options.number_of_neighbors = 1;
  winding_field* field = nullptr;
  winding_refusal refusal;
  const std::vector<Point> points = {{0, 0, 0}};
  EXPECT_EQ(winding_points(arrayOf(points), arrayOf(points), {}, &options, &run, &field, &refusal),
    WINDING_REFUSED);
  EXPECT_STREQ(refusal.parameter, "number_of_neighbors");
  EXPECT_EQ(std::string(refusal.text), "Number Of Neighbors is 1; it must be 3 to 1000");
}

TEST(Panels, SayWhyAMethodIsUsed)
{
  const Field field = fieldOf(shapes::cube({0, 0, 0}, {1, 1, 1}));
  auto info = with(winding_field_info_init);
  ASSERT_EQ(winding_describe(field.get(), &info, nullptr), WINDING_OK);
  EXPECT_NE(std::string(info.reason).find("closed"), std::string::npos) << info.reason;
  EXPECT_EQ(info.mean_point_area, 0);
  std::int64_t few = 0, many = 0;
  ASSERT_EQ(winding_expect_memory(field.get(), 10, 0, &few, nullptr), WINDING_OK);
  ASSERT_EQ(winding_expect_memory(field.get(), 10, 1, &many, nullptr), WINDING_OK);
  EXPECT_LT(few, many);
}

TEST(Verification, FindsAnErrorThatWasMade)
{
  const Field field = fieldOf(shapes::cube({0, 0, 0}, {1, 1, 1}));
  const winding_grid grid = gridAround({-0.5, -0.5, -0.5}, {1.5, 1.5, 1.5}, 9);
  std::vector<double> w(sizeOf(grid));
  auto values = with(winding_values_init);
  values.type = WINDING_FLOAT64;
  values.winding = w.data();
  ASSERT_EQ(winding_evaluate_grid(field.get(), &grid, nullptr, nullptr, &values, nullptr, nullptr),
    WINDING_OK);
  auto found = with(winding_verification_init);
  const auto verify = [&]
  {
    EXPECT_EQ(winding_verify(field.get(), &grid, nullptr, arrayOf(w), 50, nullptr, &found, nullptr),
      WINDING_OK);
  };
  verify();
  EXPECT_GT(found.samples, 30);
  EXPECT_LT(found.max_error, 1e-12);
  for (double& value : w)
  {
    value += 0.25;
  }
  verify();
  EXPECT_NEAR(found.max_error, 0.25, 1e-12);
  EXPECT_NEAR(found.rms_error, 0.25, 1e-12);
}

TEST(Labels, OfPartsAreThoseOfTheWhole)
{
  const Field left = fieldOf(shapes::cube({0, 0, 0}, {2, 1, 1}));
  const Field right = fieldOf(shapes::cube({1.25, 0, 0}, {4, 1, 1}));
  const winding_grid grid = {{0.5, 0.5, 0.5}, {1, 1, 1}, {5, 1, 1}};
  const winding_field* const fields[] = {left.get(), right.get()};
  auto options = with(winding_label_options_init);
  options.coverage = WINDING_COVERAGE_FRACTION;
  std::vector<std::uint16_t> whole(5), part(3);
  std::vector<float> first(5), second(5);
  float* const shares[] = {first.data(), second.data()};
  auto arrays = with(winding_labels_init);
  arrays.labels = whole.data();
  arrays.shares = shares;
  const auto label = [&](const std::int32_t* extent)
  {
    EXPECT_EQ(winding_label(
                fields, nullptr, 2, &grid, extent, nullptr, &options, &arrays, nullptr, nullptr),
      WINDING_OK);
  };
  label(nullptr);
  EXPECT_EQ(whole, (std::vector<std::uint16_t>{1, 1, 2, 2, 0}));
  EXPECT_EQ(first, (std::vector<float>{1, 1, 0, 0, 0}));
  EXPECT_EQ(second, (std::vector<float>{0, 0.75, 1, 1, 0}));
  arrays.labels = part.data();
  arrays.shares = nullptr;
  const std::int32_t extent[] = {1, 3, 0, 0, 0, 0};
  label(extent);
  EXPECT_TRUE(std::equal(part.begin(), part.end(), whole.begin() + 1));
  options.coverage = WINDING_COVERAGE_CENTER;
  arrays.shares = shares;
  EXPECT_EQ(
    winding_label(fields, nullptr, 2, &grid, nullptr, nullptr, &options, &arrays, nullptr, nullptr),
    WINDING_MISUSED);
}

TEST(Vertices, ShareTheAreaOfTheirMesh)
{
  const Mesh mesh = shapes::cube({0, 0, 0}, {1, 1, 1});
  const winding_polygons polygons = polygonsOf(mesh);
  std::vector<double> normals(3 * mesh.points.size()), areas(mesh.points.size());
  ASSERT_EQ(winding_vertices(
              arrayOf(mesh.points), &polygons, nullptr, normals.data(), areas.data(), nullptr),
    WINDING_OK);
  EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), 6, 1e-12);
}

TEST(Clouds, HaveReportsAndNormalsToTurn)
{
  const Mesh ball = shapes::icosphere(3);
  const std::vector<Point>& normals = ball.points;
  std::vector<Point> inward;
  for (const Point& normal : normals)
  {
    inward.push_back(-normal);
  }
  std::vector<std::uint8_t> turned(normals.size());
  const auto turn = [&](const std::vector<Point>& directions)
  {
    EXPECT_EQ(winding_orient_normals(
                arrayOf(ball.points), arrayOf(directions), nullptr, turned.data(), nullptr),
      WINDING_OK);
    return static_cast<std::size_t>(std::count(turned.begin(), turned.end(), 1));
  };
  EXPECT_EQ(turn(normals), 0u);
  EXPECT_EQ(turn(inward), inward.size());
  auto report = with(winding_cloud_report_init);
  ASSERT_EQ(
    winding_examine_points(arrayOf(ball.points), arrayOf(normals), nullptr, &report, nullptr),
    WINDING_OK);
  EXPECT_EQ(report.points, static_cast<std::int64_t>(normals.size()));
  EXPECT_EQ(report.normals, 1);
  EXPECT_GT(report.outward_share, 0.9);
}

TEST(Tables, KeepTheirColumns)
{
  const std::string path = testing::TempDir() + "panels_test.csv";
  std::ofstream(path) << "x,y,z,area,t,name\n1,2,3,4,7,a\n5,6,7,8,9,b\n";
  winding_mesh* mesh = nullptr;
  ASSERT_EQ(winding_read_table(path.c_str(), 1, nullptr, &mesh, nullptr), WINDING_OK);
  auto arrays = with(winding_mesh_arrays_init);
  ASSERT_EQ(winding_mesh_show(mesh, &arrays, nullptr), WINDING_OK);
  ASSERT_EQ(arrays.column_count, 2);
  EXPECT_EQ(arrays.point_areas[1], 8);
  EXPECT_EQ(arrays.vertex_count, 1);
  auto column = with(winding_column_init);
  ASSERT_EQ(winding_mesh_column(mesh, 0, &column, nullptr), WINDING_OK);
  EXPECT_STREQ(column.name, "t");
  EXPECT_EQ(column.numbers[1], 9);
  ASSERT_EQ(winding_mesh_column(mesh, 1, &column, nullptr), WINDING_OK);
  EXPECT_EQ(column.numbers, nullptr);
  EXPECT_STREQ(column.texts[0], "a");
  EXPECT_EQ(winding_mesh_column(mesh, 2, &column, nullptr), WINDING_MISUSED);
  winding_mesh_free(mesh);
}

TEST(Tables, MayBeOtherFilesOfPoints)
{
  const auto columnsOf = [](const std::string& name, const char* text, const char* columns)
  {
    const std::string path = testing::TempDir() + name;
    std::ofstream(path) << text;
    winding_mesh* mesh = nullptr;
    EXPECT_EQ(columns ? winding_read_columns(path.c_str(), columns, nullptr, &mesh, nullptr)
                      : winding_read_table(path.c_str(), 1, nullptr, &mesh, nullptr),
      WINDING_OK);
    auto arrays = with(winding_mesh_arrays_init);
    EXPECT_EQ(winding_mesh_show(mesh, &arrays, nullptr), WINDING_OK);
    std::string words;
    for (std::int64_t i = 0; i < arrays.column_count; ++i)
    {
      auto column = with(winding_column_init);
      EXPECT_EQ(winding_mesh_column(mesh, i, &column, nullptr), WINDING_OK);
      words += std::string(column.name) + "=" +
               (column.texts ? column.texts[1] : std::to_string(std::lround(column.numbers[1]))) +
               " ";
    }
    winding_mesh_free(mesh);
    return words;
  };
  EXPECT_EQ(columnsOf("panels_test.ply",
              "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
              "property float z\nproperty float intensity\nend_header\n1 2 3 4\n5 6 7 8\n",
              nullptr),
    "intensity=8 ");
  const char* const points = "x y z intensity\n1 2 3 4\n5 6 7 8\n";
  EXPECT_EQ(columnsOf("panels_test.xyz", points, nullptr), "intensity=8 ");
  EXPECT_EQ(columnsOf("panels_test.xyz", points, "x=y y=x"), "intensity=8 ");
  EXPECT_EQ(columnsOf("panels_test.csv", "E,N,H,t,name\n1,2,3,4,a\n5,6,7,8,b\n", "x=E y=N z=H"),
    "t=8 name=b ");
}

TEST(LevelSurface, ThatCannotBeNumberedIsRefused)
{
  const Field field = fieldOf(shapes::cube({0, 0, 0}, {1, 1, 1}));
  winding_grid grid = gridAround({-0.5, -0.5, -0.5}, {1.5, 1.5, 1.5}, 100);
  grid.dimensions[0] = 2000000000;
  grid.spacing[0] = 1e-9;
  double bytes = 0;
  ASSERT_EQ(winding_expect_surface(field.get(), &grid, nullptr, nullptr, nullptr, &bytes, nullptr),
    WINDING_OK);
  EXPECT_GT(bytes, 1e10);
  winding_mesh* mesh = nullptr;
  winding_refusal refusal;
  EXPECT_EQ(winding_level_surface(field.get(), &grid, nullptr, nullptr, nullptr, &mesh, &refusal),
    WINDING_REFUSED);
  EXPECT_NE(std::string(refusal.text).find("not enough memory"), std::string::npos) << refusal.text;
}
