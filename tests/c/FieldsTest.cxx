// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Calls.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace
{

using namespace calls;
using shapes::Mesh;
using shapes::Point;

winding_field_info describe(const Field& field)
{
  auto info = with(winding_field_info_init);
  EXPECT_EQ(winding_describe(field.get(), &info, nullptr), WINDING_OK);
  return info;
}

/// The status of a field of a mesh, and why.
winding_status tryFaces(const Mesh& mesh, const winding_options& options, winding_refusal& refusal)
{
  winding_field* field = nullptr;
  const winding_polygons polygons = polygonsOf(mesh);
  const winding_status status =
    winding_faces(arrayOf(mesh.points), &polygons, &options, nullptr, &field, &refusal);
  EXPECT_EQ(field == nullptr, status != WINDING_OK);
  winding_field_free(field);
  return status;
}

double windingAt(const Field& field, const Point& place)
{
  double w = -1;
  auto values = with(winding_values_init);
  values.type = WINDING_FLOAT64;
  values.winding = &w;
  EXPECT_EQ(winding_evaluate_points(field.get(), {place.data(), 1, 0, WINDING_FLOAT64}, nullptr,
              &values, nullptr, nullptr),
    WINDING_OK);
  return w;
}

} // namespace

TEST(Library, HasTheVersionOfItsHeader)
{
  EXPECT_EQ(winding_abi(), WINDING_ABI);
  EXPECT_STREQ(winding_version(), WINDING_PROJECT_VERSION);
}

TEST(Faces, AreDescribed)
{
  const Mesh ball = shapes::icosphere(3);
  const winding_field_info closed = describe(fieldOf(ball));
  EXPECT_EQ(closed.is_surface, 1);
  EXPECT_EQ(closed.primitives, 1280);
  EXPECT_EQ(closed.net_boundary_edges, 0);
  EXPECT_EQ(closed.method, WINDING_METHOD_ROWS);
  double area = 0, volume = 0;
  ASSERT_EQ(winding_measure(fieldOf(ball).get(), &area, &volume, nullptr), WINDING_OK);
  EXPECT_NEAR(volume, 4.1888, 0.04); // measured: 4.1527
  EXPECT_NEAR(area, 12.566, 0.06);   // measured: 12.511
  EXPECT_EQ(winding_measure(fieldOf(ball).get(), nullptr, nullptr, nullptr), WINDING_OK);
  EXPECT_EQ(winding_measure(nullptr, &area, &volume, nullptr), WINDING_MISUSED);
  EXPECT_EQ(closed.bounds[1], 1);

  const winding_field_info open = describe(fieldOf(ball.part(0, 1279)));
  EXPECT_EQ(open.boundary_edges, 3);
  EXPECT_EQ(open.net_boundary_edges, 3);
  EXPECT_TRUE(std::isnan(describe(fieldOf(Mesh())).bounds[0]));
}

TEST(Faces, MayHaveAnyTypesAndStrides)
{
  const Mesh box = shapes::cube();
  const Point place(0.3, 0.4, 0.6);
  EXPECT_EQ(windingAt(fieldOf(box), place), 1);

  // Four numbers a row, in single precision, and ids of 64 bits with one that is not read.
  std::vector<float> points;
  std::vector<std::int64_t> ids;
  for (const Point& p : box.points)
  {
    points.insert(points.end(),
      {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]), NAN});
  }
  for (const auto& t : box.triangles)
  {
    ids.insert(ids.end(), {t[0], t[1], t[2], -7});
  }
  winding_polygons polygons = {{ids.data(), 12, 4, WINDING_INT64}, {nullptr, 0, 0, 0}};
  winding_field* field = nullptr;
  ASSERT_EQ(winding_faces(
              {points.data(), 8, 4, WINDING_FLOAT32}, &polygons, nullptr, nullptr, &field, nullptr),
    WINDING_OK);
  const Field owned(field, winding_field_free);
  EXPECT_EQ(windingAt(owned, place), 1);
}

TEST(Faces, MayBePolygons)
{
  const std::vector<Point> points = {
    {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  const std::vector<std::int32_t> corners = {
    0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  const std::vector<std::int64_t> offsets = {0, 4, 8, 12, 16, 20, 24};
  winding_polygons polygons = {
    {corners.data(), 24, 0, WINDING_INT32}, {offsets.data(), 7, 0, WINDING_INT64}};
  winding_field* field = nullptr;
  ASSERT_EQ(
    winding_faces(arrayOf(points), &polygons, nullptr, nullptr, &field, nullptr), WINDING_OK);
  const Field box(field, winding_field_free);
  EXPECT_EQ(windingAt(box, {0.5, 0.4, 0.3}), 1);
  EXPECT_EQ(describe(box).primitives, 12);

  for (const std::vector<std::int64_t>& wrong :
    {std::vector<std::int64_t>{0, 4, 3}, {-1, 4}, {0, 25}, {0, std::int64_t(1) << 60}})
  {
    polygons.offsets = {wrong.data(), static_cast<int64_t>(wrong.size()), 0, WINDING_INT64};
    winding_refusal refusal;
    EXPECT_EQ(winding_faces(arrayOf(points), &polygons, nullptr, nullptr, &field, &refusal),
      WINDING_MISUSED);
    EXPECT_NE(std::string(refusal.text).find("offsets"), std::string::npos) << refusal.text;
    EXPECT_EQ(field, nullptr);
  }
}

TEST(Faces, ThatCannotBeUsedAreToldOrRefused)
{
  Mesh ball = shapes::icosphere(1);
  ball.points[3][1] = std::numeric_limits<double>::quiet_NaN();
  Warnings told;
  EXPECT_GT(describe(fieldOf(ball, nullptr, &told.run)).dropped, 0);
  ASSERT_GE(told.texts.size(), 1u);
  EXPECT_NE(told.texts[0].find("unusable"), std::string::npos) << told.texts[0];

  winding_refusal refusal;
  for (Point& point : ball.points)
  {
    point[0] = 1e120;
  }
  EXPECT_EQ(tryFaces(ball, with(winding_options_init), refusal), WINDING_REFUSED);
  EXPECT_NE(std::string(refusal.text).find("1e+120"), std::string::npos) << refusal.text;
}

TEST(Options, OutOfRangeAreRefusedByName)
{
  const auto refusalOf = [](auto member, auto value)
  {
    auto options = with(winding_options_init);
    options.*member = value;
    winding_refusal refusal;
    EXPECT_EQ(tryFaces(shapes::cube(), options, refusal), WINDING_REFUSED) << refusal.text;
    EXPECT_EQ(std::string(refusal.text).rfind(refusal.parameter, 0), 0u) << refusal.text;
    return std::string(refusal.parameter);
  };
  EXPECT_EQ(refusalOf(&winding_options::method, 5), "method");
  EXPECT_EQ(refusalOf(&winding_options::tolerance, -1.0), "tolerance");
  EXPECT_EQ(refusalOf(&winding_options::tolerance, std::nan("")), "tolerance");
  EXPECT_EQ(refusalOf(&winding_options::regularization, 4.5), "regularization");
  EXPECT_EQ(refusalOf(&winding_options::point_area, -1.0), "point_area");
  EXPECT_EQ(refusalOf(&winding_options::number_of_neighbors, 2), "number_of_neighbors");
  EXPECT_EQ(refusalOf(&winding_options::normal_estimation, -1), "normal_estimation");
}

TEST(Options, AreNamedInTheWordsThatAreAskedFor)
{
  Mesh inward = shapes::cube().with(shapes::cube({2, 0, 0}, {3, 1, 1}).reversed());
  std::swap(inward.triangles[0][0], inward.triangles[0][1]);
  for (const int words : {WINDING_WORDS_C, WINDING_WORDS_PYTHON})
  {
    Warnings told;
    told.run.words = words;
    fieldOf(inward, nullptr, &told.run);
    ASSERT_EQ(told.texts.size(), 1u);
    const char* const name = words == WINDING_WORDS_C ? "(orient_faces = 1)" : "orient_faces=True";
    EXPECT_NE(told.texts[0].find(name), std::string::npos) << told.texts[0];
  }
}

TEST(Points, HaveAFieldOfTheirNormals)
{
  const Mesh ball = shapes::icosphere(4); // a point of the unit sphere is its own normal
  winding_field* field = nullptr;
  ASSERT_EQ(winding_points(arrayOf(ball.points), arrayOf(ball.points), {nullptr, 0, 0, 0}, nullptr,
              nullptr, &field, nullptr),
    WINDING_OK);
  const Field cloud(field, winding_field_free);
  EXPECT_NEAR(windingAt(cloud, {0.1, 0.2, 0.3}), 1, 0.01);
  EXPECT_NEAR(windingAt(cloud, {2, 1, 0}), 0, 0.01);
  EXPECT_EQ(describe(cloud).is_surface, 0);

  winding_refusal refusal;
  const winding_array none = {nullptr, 0, 0, 0};
  EXPECT_EQ(winding_points(arrayOf(ball.points), none, none, nullptr, nullptr, &field, &refusal),
    WINDING_REFUSED);
  EXPECT_STREQ(refusal.parameter, "estimate_normals");
  auto options = with(winding_options_init);
  options.estimate_normals = 1;
  ASSERT_EQ(winding_points(arrayOf(ball.points), none, none, &options, nullptr, &field, &refusal),
    WINDING_OK);
  const Field estimated(field, winding_field_free);
  EXPECT_NEAR(windingAt(estimated, {0.1, 0.2, 0.3}), 1, 0.01);
  EXPECT_EQ(describe(estimated).normals_estimated, 1);
}
