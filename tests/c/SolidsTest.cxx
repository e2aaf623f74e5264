#include "Calls.h"

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
  const auto label = [&](int overlap, const std::uint16_t* as)
  {
    EXPECT_EQ(winding_label(fields, as, 2, &grid, nullptr, overlap, WINDING_COVERAGE_CENTER,
                labels.data(), counts.data(), nullptr, nullptr),
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
  EXPECT_EQ(winding_label(fields, numbers, 2, &grid, nullptr, 4, WINDING_COVERAGE_CENTER,
              labels.data(), nullptr, nullptr, &refusal),
    WINDING_REFUSED);
  EXPECT_STREQ(refusal.parameter, "overlap_rule");
}

TEST(Labels, ThatAreMissingAreTold)
{
  const Mesh ball = shapes::icosphere(2);
  const Field inward = fieldOf(ball.reversed()),
              far = fieldOf(ball.mapped([](const Point&p) { return Point(p + Point(50, 0, 0)); }));
  const Field thin = fieldOf(shapes::cube({0.11, 0.11, 0.11}, {0.12, 0.12, 0.12}));
  const winding_grid grid = gridAround({-1, -1, -1}, {1, 1, 1}, 8);
  const winding_field* const fields[] = {inward.get(), far.get(), thin.get()};
  std::vector<std::uint16_t> labels(sizeOf(grid));
  Warnings told;
  ASSERT_EQ(winding_label(
              fields, nullptr, 3, &grid, nullptr, 0, 0, labels.data(), nullptr, &told.run, nullptr),
    WINDING_OK);
  ASSERT_EQ(told.texts.size(), 3u);
  EXPECT_NE(told.texts[0].find("1 of 3 solids ('1')"), std::string::npos) << told.texts[0];
  EXPECT_NE(told.texts[1].find("1 of 3 solids ('2')"), std::string::npos) << told.texts[1];
  EXPECT_NE(told.texts[2].find("1 of 3 solids ('3')"), std::string::npos) << told.texts[2];
}

TEST(SolidsOfASurface, AreNumberedByTheirTriangles)
{
  const Mesh ball = shapes::icosphere(2);
  Mesh mesh = shapes::cube({5, 5, 5}, {6, 6, 6})
                .with(ball)
                .with(ball.reversed().mapped([](const Point& p) { return Point(0.5 * p); }));
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
  EXPECT_EQ(report.inconsistent_edges, 3);
  ASSERT_FALSE(told.texts.empty());
  EXPECT_NE(told.texts[0].find("orient_faces"), std::string::npos) << told.texts[0];
}

TEST(Orientation, TurnsAndLeavesOutPolygons)
{
  Mesh mesh = shapes::cube();
  mesh.triangles.push_back(mesh.triangles[3]);
  std::swap(mesh.triangles[7][0], mesh.triangles[7][1]);
  const winding_polygons polygons = polygonsOf(mesh);
  std::vector<std::uint8_t> turned(13), leftOut(13);
  ASSERT_EQ(winding_orient(
              arrayOf(mesh.points), &polygons, nullptr, turned.data(), leftOut.data(), nullptr),
    WINDING_OK);
  std::vector<std::uint8_t> expected(13);
  expected[7] = 1;
  EXPECT_EQ(turned, expected);
  expected = std::vector<std::uint8_t>(13);
  expected[12] = 1;
  EXPECT_EQ(leftOut, expected);
}
