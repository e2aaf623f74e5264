// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AllCalls.h"
#include "messages/Options.h"

#include <atomic>
#include <cctype>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <regex>
#include <set>
#include <sstream>
#include <thread>

namespace
{

using namespace calls;
using shapes::Mesh;
using shapes::Point;

/// Expects WINDING_MISUSED of all calls that `spoil` concerns, which returns whether it does.
void expectMisuse(const std::function<void(Arguments&)>& spoil, const std::string& those)
{
  for (const Call& call : allCalls)
  {
    if (those.find(call.name) == std::string::npos)
    {
      continue;
    }
    Arguments arguments;
    spoil(arguments);
    EXPECT_EQ(call.make(arguments), WINDING_MISUSED) << call.name << arguments.refusal.text;
    EXPECT_NE(arguments.refusal.text[0], 0) << call.name;
    EXPECT_EQ(arguments.madeField, nullptr);
    EXPECT_EQ(arguments.madeMesh, nullptr);
  }
}

} // namespace

TEST(Border, LetsEveryRightCallPass)
{
  for (const Call& call : allCalls)
  {
    Arguments arguments;
    EXPECT_EQ(call.make(arguments), WINDING_OK) << call.name << arguments.refusal.text;
    EXPECT_STREQ(arguments.refusal.text, "");
    arguments.release();
  }
}

/// These tests call every function that returns a status. A new one has to join `allCalls`.
TEST(Border, IsThatOfTheHeader)
{
  std::ifstream file(WINDING_HEADER);
  const std::string header((std::istreambuf_iterator<char>(file)), {});
  const std::regex declaration("WINDING_API winding_status (\\w+)\\(");
  std::set<std::string> declared, called;
  for (std::sregex_iterator match(header.begin(), header.end(), declaration), end; match != end;
       ++match)
  {
    declared.insert((*match)[1]);
  }
  for (const Call& call : allCalls)
  {
    called.insert(call.name);
  }
  EXPECT_GT(declared.size(), 20);
  EXPECT_EQ(called, declared);
}

TEST(Border, RefusesWhatIsNoArray)
{
  const std::string points =
    "winding_faces winding_points winding_evaluate_points winding_cell_fractions "
    "winding_outward_polygons winding_solids "
    "winding_open_parts winding_faults winding_vertices winding_examine "
    "winding_orient winding_examine_points "
    "winding_orient_normals winding_estimate_normals "
    "winding_point_areas winding_weld winding_complete "
    "winding_nearest";
  expectMisuse([](Arguments& a) { a.points.data = nullptr; }, points);
  expectMisuse([](Arguments& a) { a.points.type = WINDING_INT32; }, points);
  expectMisuse([](Arguments& a) { a.points.type = 99; }, points);
  expectMisuse([](Arguments& a) { a.points.rows = -1; }, points);
  expectMisuse([](Arguments& a) { a.points.stride = 2; }, points);
  expectMisuse([](Arguments& a) { a.points.stride = -3; }, points);
  expectMisuse(
    [](Arguments& a) { a.points.stride = std::numeric_limits<std::int64_t>::max() / 2; }, points);
  const std::string cells = "winding_cell_fractions winding_outward_polygons";
  const std::string types = cells + " winding_check_cells winding_choose_cells";
  expectMisuse([](Arguments& a) { a.cells.types.data = nullptr; }, types);
  expectMisuse([](Arguments& a) { a.cells.types.type = WINDING_INT32; }, types);
  expectMisuse([](Arguments& a) { a.cells.types.rows = -1; }, types);
  expectMisuse([](Arguments& a) { a.cells.types.stride = 2; }, types);
  const std::string skins = "winding_outward_polygons winding_halvings";
  expectMisuse([](Arguments& a) { a.owners[0] = 2; }, skins);
  expectMisuse([](Arguments& a) { a.faceCorners[0] = -1; }, skins);
  expectMisuse([](Arguments& a) { a.faceOffsets[1] = 4; }, skins);
  expectMisuse([](Arguments& a) { a.skin.owners.rows = 2; }, skins);
  expectMisuse([](Arguments& a) { a.skin.origins = a.skin.owners; }, skins);
  expectMisuse([](Arguments& a) { a.cellCounts.size = 2; },
    "winding_choose_cells winding_halvings winding_outward_polygons winding_warn_of_cells");
  expectMisuse([](Arguments& a) { a.cells.corners.type = WINDING_FLOAT32; }, cells);
  expectMisuse([](Arguments& a) { a.cells.offsets.rows = 2; }, cells);
  expectMisuse([](Arguments& a) { a.offsets[1] = 22; }, cells);
  const std::string polygons = "winding_faces winding_solids winding_open_parts winding_faults "
                               "winding_vertices winding_examine winding_orient winding_complete "
                               "winding_nearest";
  expectMisuse([](Arguments& a) { a.polygons.corners.data = nullptr; }, polygons);
  expectMisuse([](Arguments& a) { a.polygons.corners.type = WINDING_FLOAT64; }, polygons);
  expectMisuse([](Arguments& a) { a.polygons.corners.stride = 1; }, polygons);
}

TEST(Border, RefusesStructsWithoutASizeAndNullPointers)
{
  expectMisuse(
    [](Arguments& a) { a.values.size = 0; }, "winding_evaluate_grid winding_evaluate_points");
  expectMisuse([](Arguments& a) { a.rule.size = 3; },
    "winding_evaluate_grid winding_evaluate_points winding_cell_fractions winding_level_surface "
    "winding_boolean winding_label");
  expectMisuse([](Arguments& a) { a.options.size = 0; },
    "winding_faces winding_points winding_estimate_normals winding_point_areas winding_complete "
    "winding_complete_bounds winding_nearest");
  expectMisuse([](Arguments& a) { a.field.reset(); },
    "winding_evaluate_grid winding_evaluate_points winding_cell_fractions winding_level_surface "
    "winding_boolean winding_label");
  const auto spoilGrid = "winding_evaluate_grid winding_level_surface winding_boolean "
                         "winding_voxel_surface winding_label";
  expectMisuse([](Arguments& a) { a.grid.dimensions[2] = 0; }, spoilGrid);
  expectMisuse([](Arguments& a) { a.grid.spacing[1] = -1; }, spoilGrid);
  expectMisuse([](Arguments& a) { a.grid.origin[0] = std::nan(""); }, spoilGrid);

  Arguments a;
  EXPECT_EQ(
    winding_faces(a.points, nullptr, nullptr, nullptr, &a.madeField, nullptr), WINDING_MISUSED);
  EXPECT_EQ(
    winding_faces(a.points, &a.polygons, nullptr, nullptr, nullptr, nullptr), WINDING_MISUSED);
  EXPECT_EQ(winding_describe(nullptr, nullptr, nullptr), WINDING_MISUSED);
  EXPECT_EQ(winding_lay_out_grid(nullptr, nullptr, &a.grid, nullptr), WINDING_MISUSED);
  EXPECT_EQ(winding_mesh_show(nullptr, nullptr, nullptr), WINDING_MISUSED);
  EXPECT_EQ(winding_read(nullptr, nullptr, &a.madeMesh, nullptr), WINDING_MISUSED);
  auto labels = with(winding_labels_init);
  labels.labels = a.labels.data();
  EXPECT_EQ(winding_label(
              nullptr, nullptr, 1, &a.grid, nullptr, nullptr, nullptr, &labels, nullptr, nullptr),
    WINDING_MISUSED);
  winding_grid_request request = {};
  winding_run noSize = {};
  EXPECT_EQ(winding_lay_out_grid(&request, &noSize, &a.grid, &a.refusal), WINDING_MISUSED);
  EXPECT_EQ(winding_read("", nullptr, &a.madeMesh, nullptr), WINDING_MISUSED);
  const char* const table = a.tableFile.name();
  EXPECT_EQ(winding_read_columns(table, nullptr, nullptr, &a.madeMesh, nullptr), WINDING_MISUSED);
  for (const char* const columns : {"x", "x=none", "x=y", "x=1 x=2", "nx=1", "x=1 y=2 z=9"})
  {
    EXPECT_EQ(winding_read_columns(table, columns, nullptr, &a.madeMesh, nullptr), WINDING_REFUSED)
      << columns;
  }
  EXPECT_EQ(
    winding_read_columns(a.meshFile.name(), "x=1", nullptr, &a.madeMesh, nullptr), WINDING_REFUSED);
  EXPECT_EQ(winding_solids(a.points, &a.polygons, &noSize, a.solids.data(), nullptr, nullptr),
    WINDING_MISUSED);
  winding_field_free(nullptr);
  winding_mesh_free(nullptr);
  winding_options_init(nullptr, 8);
}

/// Callers that were compiled with an older header have smaller structs.
TEST(Border, TakesStructsOfOlderAndNewerHeaders)
{
  Arguments a;
  a.options.size = offsetof(winding_options, regularization);
  a.options.regularization = -7; // is not looked at
  EXPECT_EQ(
    winding_faces(a.points, &a.polygons, &a.options, nullptr, &a.madeField, nullptr), WINDING_OK);
  a.release();

  struct Newer
  {
    winding_options known;
    double more[4];
  };
  Newer newer;
  winding_options_init(&newer.known, sizeof newer);
  EXPECT_EQ(newer.known.size, sizeof newer);
  EXPECT_EQ(newer.more[3], 0);
  EXPECT_EQ(
    winding_faces(a.points, &a.polygons, &newer.known, nullptr, &a.madeField, nullptr), WINDING_OK);
  a.release();

  struct winding_field_info info;
  std::memset(&info, 0xFF, sizeof info);
  info.size = offsetof(winding_field_info, bounds);
  EXPECT_EQ(winding_describe(a.field.get(), &info, nullptr), WINDING_OK);
  EXPECT_EQ(info.primitives, 80);
  EXPECT_TRUE(std::isnan(info.bounds[5])) << "it is beyond the caller's struct";
}

/// Every progress call of every function asks to end it, one after the other.
TEST(Border, EndsCallsWhereverProgressAsksForIt)
{
  struct Countdown
  {
    int left;
    int calls = 0;
    double last = 0;
    std::thread::id caller = std::this_thread::get_id();
    bool isRight = true;
  };
  for (const Call& call : allCalls)
  {
    Arguments arguments;
    arguments.run.interval = 0;
    arguments.run.progress = [](double share, void* user)
    {
      auto& countdown = *static_cast<Countdown*>(user);
      countdown.isRight &=
        share >= countdown.last && share <= 1 && countdown.caller == std::this_thread::get_id();
      countdown.last = share;
      ++countdown.calls;
      return countdown.left-- == 0 ? 1 : 0;
    };
    Countdown whole = {-1};
    arguments.run.user = &whole;
    EXPECT_EQ(call.make(arguments), WINDING_OK) << call.name;
    arguments.release();
    EXPECT_TRUE(whole.isRight) << call.name;
    const int step = std::max(1, whole.calls / 50);
    for (int i = 0; i < whole.calls - 5; i += step)
    {
      Countdown countdown = {i};
      arguments.run.user = &countdown;
      const winding_status status = call.make(arguments);
      // Other threads may leave the calling one fewer blocks than in the first run.
      EXPECT_EQ(status, countdown.left < 0 ? WINDING_INTERRUPTED : WINDING_OK) << call.name << i;
      EXPECT_STREQ(arguments.refusal.text, "");
      if (status == WINDING_INTERRUPTED)
      {
        EXPECT_EQ(arguments.madeField, nullptr);
        EXPECT_EQ(arguments.madeMesh, nullptr);
      }
      arguments.release();
    }
  }
}

TEST(Border, CutsLongTextsBetweenCharacters)
{
  std::string path;
  for (int i = 0; i < 800; ++i)
  {
    path += "\xC3\xA4";
  }
  winding_mesh* mesh = nullptr;
  winding_refusal refusal;
  EXPECT_EQ(winding_read(path.c_str(), nullptr, &mesh, &refusal), WINDING_REFUSED);
  const std::string text = refusal.text;
  EXPECT_LT(text.size(), sizeof refusal.text);
  EXPECT_EQ(text.back(), '\xA4');
}

/// The members of structs have the names, defaults and choices that messages use.
TEST(Border, NamesOptionsAsMessagesDo)
{
  using winding::FrontEnd;
  using winding::Parameter;
  EXPECT_EQ(nameOf(Parameter::numberOfNeighbors, FrontEnd::c), "number_of_neighbors");
  EXPECT_EQ(howTo({Parameter::method, 3}, FrontEnd::c), "method = WINDING_METHOD_DIRECT");
  EXPECT_EQ(howTo({Parameter::coverage, 1}, FrontEnd::c), "coverage = WINDING_COVERAGE_ANY");
  EXPECT_EQ(howTo({Parameter::estimateNormals, 1}, FrontEnd::c), "estimate_normals = 1");
  EXPECT_EQ(howTo({Parameter::resolution}, FrontEnd::c), "resolution");
  const auto options = with(winding_options_init);
  const auto defaultOf = [](Parameter parameter)
  {
    double value = 0;
    std::istringstream standard(winding::optionOf(parameter)->standard); // no locale counts
    standard >> value;
    return value;
  };
  EXPECT_EQ(options.method, defaultOf(Parameter::method));
  EXPECT_EQ(options.tolerance, defaultOf(Parameter::tolerance));
  EXPECT_EQ(options.regularization, defaultOf(Parameter::regularization));
  EXPECT_EQ(options.point_area, defaultOf(Parameter::pointArea));
  EXPECT_EQ(options.number_of_neighbors, defaultOf(Parameter::numberOfNeighbors));
  EXPECT_EQ(options.estimate_normals, defaultOf(Parameter::estimateNormals));
  EXPECT_EQ(options.normal_estimation, defaultOf(Parameter::normalEstimation));
  EXPECT_EQ(options.orient_faces, defaultOf(Parameter::orientFaces));
  EXPECT_EQ(options.ignore_open_parts, defaultOf(Parameter::ignoreOpenParts));
  const auto request = with(winding_grid_request_init);
  EXPECT_EQ(request.resolution, defaultOf(Parameter::resolution));
  EXPECT_EQ(request.padding, defaultOf(Parameter::padding));
  EXPECT_EQ(request.voxel_size, defaultOf(Parameter::voxelSize));
  const auto rule = with(winding_rule_init);
  EXPECT_EQ(rule.winding_threshold, defaultOf(Parameter::windingThreshold));
  EXPECT_EQ(rule.inside_rule, defaultOf(Parameter::insideRule));
  EXPECT_EQ(with(winding_values_init).coverage_samples, defaultOf(Parameter::coverageSamples));
  const auto surface = with(winding_surface_options_init);
  EXPECT_EQ(surface.features, defaultOf(Parameter::features));
  EXPECT_EQ(surface.generate_normals, defaultOf(Parameter::generateNormals));
  EXPECT_EQ(surface.close_border, defaultOf(Parameter::closeBorder));
  EXPECT_EQ(surface.fill_cavities, defaultOf(Parameter::fillCavities));
  EXPECT_EQ(surface.offset, defaultOf(Parameter::offset));
  EXPECT_EQ(surface.shell, defaultOf(Parameter::shell));
  EXPECT_EQ(surface.shell_side, defaultOf(Parameter::shellSide));
}
