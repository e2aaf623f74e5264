// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/// Surfaces and points with what options say that they lack.

#include "Calls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

namespace
{

using namespace calls;

winding_report reportOn(const winding_mesh* mesh)
{
  auto arrays = with(winding_mesh_arrays_init);
  EXPECT_EQ(winding_mesh_show(mesh, &arrays, nullptr), WINDING_OK);
  EXPECT_EQ(arrays.type, WINDING_FLOAT64);
  const winding_array points = {arrays.points, arrays.point_count, 0, WINDING_FLOAT64};
  const winding_polygons polygons = {{arrays.corners, arrays.corner_count, 0, WINDING_INT64},
    {arrays.offsets, arrays.polygon_count + 1, 0, WINDING_INT64}};
  auto report = with(winding_report_init);
  EXPECT_EQ(winding_examine(points, &polygons, nullptr, &report, nullptr), WINDING_OK);
  return report;
}

} // namespace

TEST(Completion, MirrorsAndClosesAnOpenBox)
{
  const shapes::Mesh box = shapes::openCube(); // open at z = 1
  const winding_polygons polygons = polygonsOf(box);
  const winding_array points = arrayOf(box.points);
  auto options = with(winding_options_init);
  for (const auto& [mirror, base, volume] :
    {std::tuple<const char*, const char*, double>{"z=1", nullptr, 2}, {nullptr, "up", 1},
      {nullptr, "z=3", 3}, {"x=0", "z=3", 6}})
  {
    options.mirror = mirror;
    options.flat_base = base;
    winding_mesh* made = nullptr;
    ASSERT_EQ(winding_complete(points, &polygons, &options, nullptr, &made, nullptr), WINDING_OK);
    const OwnedMesh mesh(made, winding_mesh_free);
    const winding_report report = reportOn(made);
    EXPECT_EQ(report.closed, 1);
    EXPECT_NEAR(report.volume, volume, 1e-12);

    double bounds[6] = {0, 1, 0, 1, 0, 1};
    ASSERT_EQ(winding_complete_bounds(&options, bounds, nullptr), WINDING_OK);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(bounds[2 * axis], report.bbox[axis]);
      EXPECT_EQ(bounds[2 * axis + 1], report.bbox[axis + 3]);
    }

    // A field takes the same words.
    winding_field* field = nullptr;
    ASSERT_EQ(winding_faces(points, &polygons, &options, nullptr, &field, nullptr), WINDING_OK);
    const Field owned(field, winding_field_free);
    double area = 0, measured = 0;
    ASSERT_EQ(winding_measure(field, &area, &measured, nullptr), WINDING_OK);
    EXPECT_NEAR(measured, volume, 1e-12);
  }
}

TEST(Completion, KeepsEmptyBoundsAndRefusesWrongWords)
{
  auto options = with(winding_options_init);
  options.mirror = "y=0";
  double none[6] = {1, -1, 1, -1, 1, -1};
  EXPECT_EQ(winding_complete_bounds(&options, none, nullptr), WINDING_OK);
  EXPECT_EQ(none[1], -1);
  winding_refusal refusal = {};
  for (const char* wrong : {"y", "up", "x=0 y=0 z=0 z=1"})
  {
    options.mirror = wrong;
    EXPECT_EQ(winding_complete_bounds(&options, none, &refusal), WINDING_REFUSED) << wrong;
    EXPECT_STREQ(refusal.parameter, "mirror");
  }
  options.mirror = nullptr;
  options.sheet_side = "z=0";
  EXPECT_EQ(winding_complete_bounds(&options, none, &refusal), WINDING_REFUSED);
  EXPECT_STREQ(refusal.parameter, "sheet_side");
  options.sheet_side = nullptr;
  options.weld_tolerance = -1;
  winding_mesh* made = nullptr;
  const shapes::Mesh box = shapes::cube();
  const winding_polygons polygons = polygonsOf(box);
  EXPECT_EQ(winding_complete(arrayOf(box.points), &polygons, &options, nullptr, &made, &refusal),
    WINDING_REFUSED);
  EXPECT_EQ(made, nullptr);
}

TEST(Completion, WeldsPoints)
{
  const std::vector<double> points = {0, 0, 0, 1, 0, 0, 1e-9, 0, 0, std::nan(""), 0, 0};
  const winding_array given = {points.data(), 4, 0, WINDING_FLOAT64};
  std::vector<double> welded(12);
  ASSERT_EQ(winding_weld(given, 1e-8, nullptr, welded.data(), nullptr), WINDING_OK);
  EXPECT_EQ(welded[6], welded[0]);
  EXPECT_EQ(welded[3], 1);
  EXPECT_TRUE(std::isnan(welded[9]));
  EXPECT_EQ(winding_weld(given, -1, nullptr, welded.data(), nullptr), WINDING_REFUSED);
  EXPECT_EQ(winding_weld(given, 1, nullptr, nullptr, nullptr), WINDING_MISUSED);
  EXPECT_EQ(
    winding_weld({nullptr, 0, 0, WINDING_FLOAT64}, 1, nullptr, nullptr, nullptr), WINDING_OK);
}

TEST(Completion, DividesByASheet)
{
  const shapes::Mesh box = shapes::openCube();
  const shapes::Mesh sheet = box.part(0, 2); // one side of the box
  const winding_polygons polygons = polygonsOf(sheet);
  auto options = with(winding_options_init);
  const shapes::Point a = sheet.points[sheet.triangles[0][0]],
                      b = sheet.points[sheet.triangles[0][1]],
                      c = sheet.points[sheet.triangles[0][2]];
  const shapes::Point normal = (b - a).cross(c - a).normalized();
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  for (const char sign : {'+', '-'})
  {
    const std::string side = std::string(1, sign) + "xyz"[axis];
    options.sheet_side = side.c_str();
    winding_field* made = nullptr;
    ASSERT_EQ(winding_faces(arrayOf(sheet.points), &polygons, &options, nullptr, &made, nullptr),
      WINDING_OK);
    const Field field(made, winding_field_free);
    const shapes::Point middle = (a + b + c) / 3;
    const double step = sign == '+' ? 1e-3 : -1e-3;
    const shapes::Point samples[2] = {
      middle + step * shapes::Point::Unit(axis), middle - step * shapes::Point::Unit(axis)};
    auto values = with(winding_values_init);
    double w[2] = {};
    values.winding = w;
    values.type = WINDING_FLOAT64;
    ASSERT_EQ(winding_evaluate_points(made, {samples[0].data(), 2, 0, WINDING_FLOAT64}, nullptr,
                &values, nullptr, nullptr),
      WINDING_OK);
    EXPECT_NEAR(w[0], 1, 0.01);
    EXPECT_NEAR(w[1], 0, 0.01);
  }
}

TEST(Completion, HasTextsAboutSpaceInAnyCoordinates)
{
  // The points are given in coordinates that are turned by 90 degrees around z, from (5.5, 0, 0)
  // on.
  const double frame[12] = {0, 1, 0, -1, 0, 0, 0, 0, 1, 5.5, 0, 0};
  const shapes::Mesh box = shapes::openCube();
  const shapes::Mesh turned = box.mapped(
    [](const shapes::Point& p) -> shapes::Point {
      return {p[1], 5.5 - p[0], p[2]};
    });
  auto options = with(winding_options_init);
  options.mirror = "x=0";
  options.flat_base = "up";
  double areas[2] = {}, volumes[2] = {};
  for (int i = 0; i < 2; ++i)
  {
    options.frame = i == 0 ? nullptr : frame;
    const Field field = fieldOf(i == 0 ? box : turned, &options);
    ASSERT_EQ(winding_measure(field.get(), &areas[i], &volumes[i], nullptr), WINDING_OK);
  }
  EXPECT_NEAR(volumes[0], 2, 1e-12);
  EXPECT_NEAR(volumes[1], 2, 1e-12);
  EXPECT_NEAR(areas[1], areas[0], 1e-12);
}
