// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Calls.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{

using namespace calls;
using shapes::Mesh;
using shapes::Point;

} // namespace

TEST(Labels, AreOfTheSolidsThatVoxelsAreIn)
{
  const Field left = fieldOf(shapes::cube({0, 0, 0}, {2, 1, 1}));
  const Field right = fieldOf(shapes::cube({1, 0, 0}, {4, 1, 1}));
  const winding_grid grid = {{0.5, 0.5, 0.5}, {1, 1, 1}, {5, 1, 1}};
  const winding_field* const fields[] = {left.get(), right.get()};
  const std::uint16_t numbers[] = {7, 300};
  std::vector<std::uint16_t> labels(5), counts(5);
  auto options = with(winding_label_options_init);
  auto arrays = with(winding_labels_init);
  arrays.labels = labels.data();
  arrays.counts = counts.data();
  const auto label = [&](int overlap, const std::uint16_t* as)
  {
    options.overlap_rule = overlap;
    EXPECT_EQ(
      winding_label(fields, as, 2, &grid, nullptr, nullptr, &options, &arrays, nullptr, nullptr),
      WINDING_OK);
    return labels;
  };
  using Row = std::vector<std::uint16_t>;
  EXPECT_EQ(label(WINDING_OVERLAP_RULE_FIRST, numbers), (Row{7, 7, 300, 300, 0}));
  EXPECT_EQ(counts, (Row{1, 2, 1, 1, 0}));
  EXPECT_EQ(label(WINDING_OVERLAP_RULE_LAST, nullptr), (Row{1, 2, 2, 2, 0}));
  EXPECT_EQ(label(WINDING_OVERLAP_RULE_SMALLEST, numbers), (Row{7, 7, 300, 300, 0}));
  EXPECT_EQ(label(WINDING_OVERLAP_RULE_LARGEST, numbers), (Row{7, 7, 300, 300, 0}));

  winding_refusal refusal;
  options.overlap_rule = 4;
  EXPECT_EQ(winding_label(
              fields, numbers, 2, &grid, nullptr, nullptr, &options, &arrays, nullptr, &refusal),
    WINDING_REFUSED);
  EXPECT_STREQ(refusal.parameter, "overlap_rule");

  // A part of the grid, with the shares of each solid.
  const std::int32_t extent[] = {1, 3, 0, 0, 0, 0};
  options = with(winding_label_options_init);
  options.coverage = WINDING_COVERAGE_FRACTION;
  // Arrays may hold anything before.
  std::vector<float> first(3, 9), second(3, 9), leftShares(3, 9), rightShares(3, 9);
  std::vector<std::uint16_t> firstLabels(3), secondLabels(3);
  float* const shares[] = {leftShares.data(), rightShares.data()};
  arrays.first_labels = firstLabels.data();
  arrays.first_shares = first.data();
  arrays.second_labels = secondLabels.data();
  EXPECT_EQ(
    winding_label(fields, numbers, 2, &grid, extent, nullptr, &options, &arrays, nullptr, &refusal),
    WINDING_MISUSED)
    << "arrays of shares go together";
  arrays.second_shares = second.data();
  arrays.shares = shares;
  ASSERT_EQ(
    winding_label(fields, numbers, 2, &grid, extent, nullptr, &options, &arrays, nullptr, &refusal),
    WINDING_OK);
  EXPECT_EQ(firstLabels, (Row{7, 300, 300}));
  EXPECT_EQ(secondLabels, (Row{300, 0, 0}));
  EXPECT_EQ(leftShares, (std::vector<float>{1, 0, 0}));
  EXPECT_EQ(rightShares, (std::vector<float>{1, 1, 1}));
}

TEST(Labels, OfNothingHaveSharesOfZero)
{
  const Field box = fieldOf(shapes::cube({0, 0, 0}, {2, 1, 1})), nothing = fieldOf(Mesh());
  const winding_grid grid = {{0.5, 0.5, 0.5}, {1, 1, 1}, {3, 1, 1}};
  const winding_field* const fields[] = {nothing.get(), box.get()};
  std::vector<std::uint16_t> labels(3, 9);
  // Arrays may hold anything before.
  std::vector<float> ofNothing(3, 9), ofBox(3, 9);
  float* const shares[] = {ofNothing.data(), ofBox.data()};
  auto options = with(winding_label_options_init);
  options.coverage = WINDING_COVERAGE_FRACTION;
  auto arrays = with(winding_labels_init);
  arrays.labels = labels.data();
  arrays.shares = shares;
  std::vector<float> first(3), second(3);
  std::vector<std::uint16_t> firstLabels(3), secondLabels(3);
  arrays.first_labels = firstLabels.data();
  arrays.first_shares = first.data();
  arrays.second_labels = secondLabels.data();
  arrays.second_shares = second.data();
  ASSERT_EQ(
    winding_label(fields, nullptr, 2, &grid, nullptr, nullptr, &options, &arrays, nullptr, nullptr),
    WINDING_OK);
  EXPECT_EQ(labels, (std::vector<std::uint16_t>{2, 2, 0}));
  EXPECT_EQ(ofNothing, (std::vector<float>{0, 0, 0}));
  EXPECT_EQ(ofBox, (std::vector<float>{1, 1, 0}));
}

TEST(Labels, ThatAreMissingAreTold)
{
  const Mesh ball = shapes::icosphere(2);
  const Field inward = fieldOf(ball.reversed()), far = fieldOf(ball.moved({50, 0, 0}));
  const Field thin = fieldOf(shapes::cube({0.11, 0.11, 0.11}, {0.12, 0.12, 0.12}));
  const winding_grid grid = gridAround({-1, -1, -1}, {1, 1, 1}, 8);
  const winding_field* const fields[] = {inward.get(), far.get(), thin.get()};
  std::vector<std::uint16_t> labels(sizeOf(grid));
  Warnings told;
  auto arrays = with(winding_labels_init);
  arrays.labels = labels.data();
  const auto label = [&]
  {
    told.texts.clear();
    ASSERT_EQ(winding_label(
                fields, nullptr, 3, &grid, nullptr, nullptr, nullptr, &arrays, &told.run, nullptr),
      WINDING_OK);
    ASSERT_EQ(told.texts.size(), 3u);
  };
  const char* const names[] = {"hull", "moon", "foil"};
  arrays.names = names;
  label();
  EXPECT_NE(told.texts[1].find("('moon')"), std::string::npos) << told.texts[1];
  arrays.names = nullptr;
  label();
  EXPECT_NE(told.texts[0].find("1 of 3 solids ('1')"), std::string::npos) << told.texts[0];
  EXPECT_NE(told.texts[1].find("1 of 3 solids ('2')"), std::string::npos) << told.texts[1];
  EXPECT_NE(told.texts[2].find("1 of 3 solids ('3')"), std::string::npos) << told.texts[2];
}

TEST(Labels, OfOpenPartsNeedNoVoxel)
{
  Mesh sheet;
  sheet.points = {Point(0.2, 0.2, 0.47), Point(0.8, 0.2, 0.47), Point(0.2, 0.8, 0.47)};
  sheet.triangles = {{0, 1, 2}};
  const Field box = fieldOf(shapes::cube()), open = fieldOf(sheet);
  const winding_grid grid = gridAround({0, 0, 0}, {1, 1, 1}, 12);
  const winding_field* const fields[] = {box.get(), open.get()};
  std::vector<std::uint16_t> labels(sizeOf(grid));
  auto arrays = with(winding_labels_init);
  arrays.labels = labels.data();
  auto asIs = with(winding_label_options_init);
  asIs.mend_source = 0;
  const auto warnings = [&]
  {
    Warnings told;
    EXPECT_EQ(winding_label(
                fields, nullptr, 2, &grid, nullptr, nullptr, &asIs, &arrays, &told.run, nullptr),
      WINDING_OK);
    return told.texts;
  };
  ASSERT_EQ(warnings().size(), 2u);
  EXPECT_EQ(warnings()[0].rfind("some solids have holes", 0), 0u) << warnings()[0];
  EXPECT_EQ(warnings()[1].rfind("some solids have no voxel inside", 0), 0u) << warnings()[1];
  const std::uint8_t areOpen[] = {0, 1};
  arrays.are_open = areOpen;
  ASSERT_EQ(warnings().size(), 1u);
  EXPECT_EQ(warnings()[0].rfind("open parts lie inside of closed ones", 0), 0u) << warnings()[0];
}

TEST(Labels, ThatAreMissingInPartAreTold)
{
  const auto movedBy = [](double x)
  {
    return shapes::icosphere(2).moved({x, 0, 0});
  };
  Mesh comb = movedBy(0);
  for (int tooth = 0; tooth < 4; ++tooth)
  {
    const double x = 5 + 0.3 * tooth;
    comb = comb.with(shapes::cube({x, -1, -1}, {x + 0.01, 1, 1}));
  }
  const Field partly = fieldOf(movedBy(0).with(movedBy(3).reversed())), lost = fieldOf(comb);
  const winding_grid grid = gridAround({-1, -1, -1}, {6, 1, 1}, 24);
  const winding_field* const fields[] = {lost.get(), partly.get()};
  std::vector<std::uint16_t> labels(sizeOf(grid));
  Warnings told;
  auto arrays = with(winding_labels_init);
  arrays.labels = labels.data();
  auto asIs = with(winding_label_options_init);
  asIs.mend_source = 0;
  ASSERT_EQ(
    winding_label(fields, nullptr, 2, &grid, nullptr, nullptr, &asIs, &arrays, &told.run, nullptr),
    WINDING_OK);
  ASSERT_EQ(told.texts.size(), 3u);
  EXPECT_NE(told.texts[0].find("1 of 2 solids ('1')"), std::string::npos) << told.texts[0];
  EXPECT_EQ(told.texts[1].rfind("others hide all voxels", 0), 0u) << told.texts[1];
  EXPECT_EQ(told.texts[2].rfind("parts of solids look inward and have no label", 0), 0u)
    << told.texts[2];
}

TEST(SolidsOfASurface, AreNumberedByTheirTriangles)
{
  const Mesh ball = shapes::icosphere(2);
  Mesh mesh = shapes::cube({5, 5, 5}, {6, 6, 6}).with(ball).with(ball.reversed().scaled(0.5));
  mesh.triangles.push_back({0, 0, 99999});
  const winding_polygons polygons = polygonsOf(mesh);
  std::vector<std::int32_t> solids(mesh.triangles.size());
  std::int64_t count = 0;
  ASSERT_EQ(
    winding_solids(arrayOf(mesh.points), &polygons, nullptr, solids.data(), &count, nullptr),
    WINDING_OK);
  EXPECT_EQ(count, 2);
  EXPECT_EQ(solids[0], 1);
  EXPECT_EQ(solids[12], 0);
  EXPECT_EQ(solids[solids.size() - 2], 0) << "a cavity is part of its solid";
  EXPECT_EQ(solids.back(), -1);
}

TEST(Labels, WarnOfSolidsInAnotherUnit)
{
  const Field left = fieldOf(shapes::cube({0, 0, 0}, {100, 100, 100}));
  const Field right = fieldOf(shapes::cube({0.1, 0, 0}, {0.2, 0.1, 0.1}));
  const winding_field* const fields[] = {left.get(), right.get()};
  const char* const names[] = {"left", "right"};
  const winding_grid grid = {{0.05, 0.05, 0.05}, {0.1, 1, 1}, {2, 1, 1}};
  std::uint16_t labels[2];
  auto arrays = with(winding_labels_init);
  arrays.labels = labels;
  arrays.names = names;
  auto options = with(winding_label_options_init);
  const auto firstWarning = [&]
  {
    Warnings told;
    EXPECT_EQ(winding_label(
                fields, nullptr, 2, &grid, nullptr, nullptr, &options, &arrays, &told.run, nullptr),
      WINDING_OK);
    return told.texts.empty() ? std::string() : told.texts[0];
  };
  const std::string start = "'right' seems to be in another unit: scale it by 1000";
  EXPECT_EQ(firstWarning().rfind(start, 0), 0u) << firstWarning();
  options.have_one_unit = 1;
  EXPECT_EQ(firstWarning().find("another unit"), std::string::npos) << firstWarning();
}

TEST(OpenParts, AreSheetsInsideOfClosedOnes)
{
  Mesh mesh = shapes::cube();
  const auto first = static_cast<std::int32_t>(mesh.points.size());
  mesh.points.insert(
    mesh.points.end(), {Point(0.2, 0.2, 0.5), Point(0.8, 0.2, 0.5), Point(0.2, 0.8, 0.5)});
  mesh.triangles.push_back({first, first + 1, first + 2});
  const winding_polygons polygons = polygonsOf(mesh);
  std::vector<std::uint8_t> open(13, 9), expected(13);
  expected[12] = 1;
  ASSERT_EQ(
    winding_open_parts(arrayOf(mesh.points), &polygons, nullptr, open.data(), nullptr), WINDING_OK);
  EXPECT_EQ(open, expected);
}

TEST(Faults, AreLoopsCapsAndEdges)
{
  Mesh mesh = shapes::cube();
  mesh.triangles.pop_back();
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
  const winding_polygons polygons = polygonsOf(mesh);
  const auto count = [&](int fault)
  {
    winding_mesh* made = nullptr;
    EXPECT_EQ(
      winding_faults(arrayOf(mesh.points), &polygons, fault, nullptr, &made, nullptr), WINDING_OK);
    auto arrays = with(winding_mesh_arrays_init);
    EXPECT_EQ(winding_mesh_show(made, &arrays, nullptr), WINDING_OK);
    winding_mesh_free(made);
    return arrays.polygon_count;
  };
  EXPECT_EQ(count(WINDING_FAULT_INCONSISTENT), 2);
  EXPECT_EQ(count(WINDING_FAULT_NON_MANIFOLD), 0);
  EXPECT_GE(count(WINDING_FAULT_BOUNDARY), 1);
  EXPECT_GE(count(WINDING_FAULT_CAPS), 2);
  winding_mesh* made = nullptr;
  EXPECT_EQ(
    winding_faults(arrayOf(mesh.points), &polygons, 4, nullptr, &made, nullptr), WINDING_MISUSED);
}

TEST(Faults, OfTheBoundaryHaveTheWidthsOfSlits)
{
  const Mesh mesh = shapes::cubeWithSlit(1e-9).with(shapes::openCube().moved({5, 0, 0}));
  const winding_polygons polygons = polygonsOf(mesh);
  winding_mesh* made = nullptr;
  ASSERT_EQ(winding_faults(
              arrayOf(mesh.points), &polygons, WINDING_FAULT_BOUNDARY, nullptr, &made, nullptr),
    WINDING_OK);
  auto arrays = with(winding_mesh_arrays_init);
  ASSERT_EQ(winding_mesh_show(made, &arrays, nullptr), WINDING_OK);
  ASSERT_EQ(arrays.polygon_count, 3);
  ASSERT_NE(arrays.slit_widths, nullptr);
  std::vector<double> widths(arrays.slit_widths, arrays.slit_widths + 3);
  std::sort(widths.begin(), widths.end());
  EXPECT_NEAR(widths[1], 1e-9, 1e-15);
  EXPECT_EQ(widths[2], 1);
  winding_mesh_free(made);
  ASSERT_EQ(
    winding_faults(arrayOf(mesh.points), &polygons, WINDING_FAULT_CAPS, nullptr, &made, nullptr),
    WINDING_OK);
  ASSERT_EQ(winding_mesh_show(made, &arrays, nullptr), WINDING_OK);
  EXPECT_EQ(arrays.slit_widths, nullptr);
  winding_mesh_free(made);
  auto report = with(winding_report_init);
  ASSERT_EQ(
    winding_examine(arrayOf(mesh.points), &polygons, nullptr, &report, nullptr), WINDING_OK);
  EXPECT_EQ(report.widest_slit, 1);
}

TEST(Examination, KnowsCallersWithoutTheWidestSlit)
{
  const Mesh mesh = shapes::openCube();
  const winding_polygons polygons = polygonsOf(mesh);
  winding_report report;
  winding_report_init(&report, sizeof report);
  report.size = offsetof(winding_report, widest_slit);
  report.widest_slit = 7;
  ASSERT_EQ(
    winding_examine(arrayOf(mesh.points), &polygons, nullptr, &report, nullptr), WINDING_OK);
  EXPECT_EQ(report.boundary_loops, 1);
  EXPECT_EQ(report.widest_slit, 7);
}

TEST(Examination, CountsAndAdvises)
{
  Mesh mesh = shapes::icosphere(2);
  std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
  const winding_polygons polygons = polygonsOf(mesh);
  auto report = with(winding_report_init);
  Warnings told;
  ASSERT_EQ(
    winding_examine(arrayOf(mesh.points), &polygons, &told.run, &report, nullptr), WINDING_OK);
  EXPECT_EQ(report.closed, 0);
  EXPECT_EQ(report.vertices, 162);
  EXPECT_EQ(report.vertices_merged, 162);
  EXPECT_EQ(report.triangles, 320);
  EXPECT_EQ(report.edges, 480);
  EXPECT_EQ(report.euler, 2);
  EXPECT_EQ(report.bbox[3], 1);
  EXPECT_GT(report.fractional_share, 0);
  EXPECT_EQ(report.boundary_edges, 0);
  EXPECT_TRUE(std::isnan(report.widest_slit)) << "there is no boundary";
  EXPECT_EQ(report.inconsistent_edges, 3);
  ASSERT_FALSE(told.texts.empty());
  EXPECT_NE(told.texts[0].find("orient_faces"), std::string::npos) << told.texts[0];
}

TEST(Orientation, CountsTrianglesAndComponentsApart)
{
  const Mesh inward = shapes::cube().reversed();
  const Mesh mesh = inward.with(shapes::cube({3, 3, 3}, {4, 4, 4})).with(inward.moved({9, 0, 0}));
  const winding_polygons polygons = polygonsOf(mesh);
  std::vector<std::uint8_t> turned(36, 9), leftOut(36, 9);
  std::int64_t triangles = 0, components = 0;
  ASSERT_EQ(winding_orient(arrayOf(mesh.points), &polygons, nullptr, turned.data(), leftOut.data(),
              &triangles, &components, nullptr),
    WINDING_OK);
  EXPECT_EQ(triangles, 24);
  EXPECT_EQ(components, 2);
  EXPECT_EQ(std::count(turned.begin(), turned.end(), 1), 24);
  EXPECT_EQ(std::count(leftOut.begin(), leftOut.end(), 0), 36);
}

TEST(Orientation, TurnsAndLeavesOutPolygons)
{
  Mesh mesh = shapes::cube();
  mesh.triangles.push_back(mesh.triangles[3]);
  std::swap(mesh.triangles[7][0], mesh.triangles[7][1]);
  const winding_polygons polygons = polygonsOf(mesh);
  std::vector<std::uint8_t> turned(13), leftOut(13);
  std::int64_t triangles = 0, components = 0;
  ASSERT_EQ(winding_orient(arrayOf(mesh.points), &polygons, nullptr, turned.data(), leftOut.data(),
              &triangles, &components, nullptr),
    WINDING_OK);
  EXPECT_EQ(triangles, 1);
  EXPECT_EQ(components, 1);
  std::vector<std::uint8_t> expected(13);
  expected[7] = 1;
  EXPECT_EQ(turned, expected);
  expected = std::vector<std::uint8_t>(13);
  expected[12] = 1;
  EXPECT_EQ(leftOut, expected);
}
