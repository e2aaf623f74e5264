// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Calls.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>

namespace
{

using namespace calls;
using shapes::Mesh;
using shapes::Point;

winding_mesh_arrays show(const OwnedMesh& mesh)
{
  auto arrays = with(winding_mesh_arrays_init);
  EXPECT_EQ(winding_mesh_show(mesh.get(), &arrays, nullptr), WINDING_OK);
  return arrays;
}

OwnedMesh surfaceOf(const Field& field, const winding_grid& grid,
  const winding_surface_options& options, const winding_run* run = nullptr)
{
  winding_mesh* mesh = nullptr;
  winding_refusal refusal;
  EXPECT_EQ(
    winding_level_surface(field.get(), &grid, nullptr, &options, run, &mesh, &refusal), WINDING_OK)
    << refusal.text;
  return {mesh, winding_mesh_free};
}

Point pointOf(const winding_mesh_arrays& arrays, std::int64_t id)
{
  const auto at = [&](const auto* numbers)
  {
    return Point(numbers[3 * id], numbers[3 * id + 1], numbers[3 * id + 2]);
  };
  return arrays.type == WINDING_FLOAT64 ? at(static_cast<const double*>(arrays.points))
                                        : at(static_cast<const float*>(arrays.points));
}

/// The volume within the polygons, taken as fans; every edge of them must be used once in each
/// sense.
double closedVolumeOf(const winding_mesh_arrays& arrays)
{
  double volume = 0;
  std::map<std::pair<std::int64_t, std::int64_t>, int> edges;
  for (std::int64_t polygon = 0; polygon < arrays.polygon_count; ++polygon)
  {
    const std::int64_t first = arrays.offsets[polygon], last = arrays.offsets[polygon + 1];
    const Point origin = pointOf(arrays, arrays.corners[first]);
    for (std::int64_t i = first; i < last; ++i)
    {
      const std::int64_t from = arrays.corners[i],
                         to = arrays.corners[i + 1 < last ? i + 1 : first];
      ++edges[{from, to}];
      --edges[{to, from}];
      volume += origin.dot(pointOf(arrays, from).cross(pointOf(arrays, to))) / 6;
    }
  }
  for (const auto& [edge, net] : edges)
  {
    EXPECT_EQ(net, 0) << edge.first << " " << edge.second;
  }
  return volume;
}

} // namespace

TEST(LevelSurface, LiesOnTheSourceAndIsClosed)
{
  const Field field = fieldOf(shapes::icosphere(4));
  const winding_grid grid = gridAround({-1, -1, -1}, {1, 1, 1}, 30);
  auto options = with(winding_surface_options_init);
  const OwnedMesh smooth = surfaceOf(field, grid, options);
  const winding_mesh_arrays arrays = show(smooth);
  EXPECT_EQ(arrays.type, WINDING_FLOAT32);
  EXPECT_EQ(arrays.corner_count, 3 * arrays.polygon_count);
  EXPECT_NEAR(closedVolumeOf(arrays), 4.16, 0.02); // measured: 4.159
  ASSERT_NE(arrays.point_normals, nullptr);
  for (std::int64_t i = 0; i < arrays.point_count; ++i)
  {
    EXPECT_NEAR(pointOf(arrays, i).norm(), 1, 0.01);
  }
  options.type = WINDING_FLOAT64;
  options.generate_normals = 0;
  const OwnedMesh precise = surfaceOf(field, grid, options);
  EXPECT_EQ(show(precise).type, WINDING_FLOAT64);
  EXPECT_EQ(show(precise).point_normals, nullptr);

  auto fidelity = with(winding_fidelity_init);
  ASSERT_EQ(
    winding_compare(field.get(), precise.get(), grid.spacing[0], 1000, nullptr, &fidelity, nullptr),
    WINDING_OK);
  EXPECT_EQ(fidelity.samples, 1000);
  EXPECT_EQ(fidelity.self_intersections, 0);
  EXPECT_LT(fidelity.largest_to_source, 0.01);
  EXPECT_GT(fidelity.largest_to_source, 0);
}

TEST(LevelSurface, IsOfAMendedSourceUnlessThatIsSwitchedOff)
{
  std::vector<std::string> notes;
  auto run = with(winding_run_init);
  run.user = &notes;
  run.warn = [](const char* text, void* user)
  {
    static_cast<std::vector<std::string>*>(user)->emplace_back(text);
  };
  const winding_grid grid = gridAround({-0.3, -0.3, -0.3}, {1.3, 1.3, 1.3}, 20);
  auto options = with(winding_surface_options_init);
  EXPECT_EQ(options.mend_source, 1);
  const Mesh box = shapes::cube(), half = box.part(0, 6).reversed().with(box.part(6, 12));
  auto ofField = with(winding_options_init);
  EXPECT_EQ(ofField.mend_source, 0);
  ofField.mend_source = 1;
  const std::string words =
    "faces were turned: if that is wrong, leave it as it came (mend_source = 0)";
  for (const Mesh& mesh : {box.reversed(), half})
  {
    for (const winding_options* given : {static_cast<winding_options*>(nullptr), &ofField})
    {
      // Without the option the field itself says what is wrong with it, too.
      const Field field = fieldOf(mesh, given, given ? &run : nullptr);
      const OwnedMesh made = surfaceOf(field, grid, options, &run);
      EXPECT_NEAR(closedVolumeOf(show(made)), 1, 0.02);
      ASSERT_EQ(notes.size(), 1u);
      EXPECT_EQ(notes[0].rfind(words, 0), 0u) << notes[0];
      notes.clear();
    }
  }
  options.mend_source = 0;
  const OwnedMesh inward = surfaceOf(fieldOf(box.reversed()), grid, options);
  EXPECT_EQ(show(inward).polygon_count, 0);
}

TEST(LevelSurface, KeepsEdgesIfItIsSharp)
{
  const Field field = fieldOf(shapes::cube());
  const winding_grid grid = gridAround({-0.3, -0.3, -0.3}, {1.3, 1.3, 1.3}, 10);
  auto options = with(winding_surface_options_init);
  options.features = WINDING_FEATURES_SHARP;
  const OwnedMesh sharp = surfaceOf(field, grid, options);
  EXPECT_NEAR(closedVolumeOf(show(sharp)), 1, 1e-6);
  EXPECT_NE(show(sharp).polygon_normals, nullptr);
  options.generate_triangles = 1;
  const OwnedMesh cut = surfaceOf(field, grid, options);
  EXPECT_EQ(show(cut).corner_count, 3 * show(cut).polygon_count);
}

TEST(LevelSurface, HasTheSidesOfVoxels)
{
  const Field field = fieldOf(shapes::cube());
  const winding_grid grid = gridAround({-0.3, -0.3, -0.3}, {1.3, 1.3, 1.3}, 16);
  auto options = with(winding_surface_options_init);
  options.features = WINDING_FEATURES_VOXELS;
  const OwnedMesh voxels = surfaceOf(field, grid, options);
  EXPECT_EQ(show(voxels).polygon_count, 6 * 8 * 8);
  EXPECT_NEAR(closedVolumeOf(show(voxels)), std::pow(8 * grid.spacing[0], 3), 1e-5);
  EXPECT_EQ(show(voxels).inside, nullptr);
  options.generate_image = 1;
  const OwnedMesh withImage = surfaceOf(field, grid, options);
  const winding_mesh_arrays arrays = show(withImage);
  ASSERT_EQ(arrays.sample_count, 16 * 16 * 16);
  EXPECT_EQ(std::count(arrays.inside, arrays.inside + arrays.sample_count, 1), 8 * 8 * 8);
  EXPECT_EQ(arrays.inside[0], 0);
  EXPECT_EQ(arrays.inside[8 + 16 * (8 + 16 * 8)], 1);
  options.features = WINDING_FEATURES_VOXELS + 1;
  winding_mesh* mesh = nullptr;
  EXPECT_EQ(winding_level_surface(field.get(), &grid, nullptr, &options, nullptr, &mesh, nullptr),
    WINDING_REFUSED);
}

TEST(LevelSurface, MovesAndBecomesAShell)
{
  const Field field = fieldOf(shapes::cube());
  const winding_grid grid = gridAround({-0.5, -0.5, -0.5}, {1.5, 1.5, 1.5}, 40);
  auto options = with(winding_surface_options_init);
  options.features = WINDING_FEATURES_SHARP;
  options.offset = -0.2;
  const OwnedMesh small = surfaceOf(field, grid, options);
  EXPECT_NEAR(closedVolumeOf(show(small)), 0.6 * 0.6 * 0.6, 1e-6);
  EXPECT_EQ(show(small).distances_from, WINDING_DISTANCES_FROM_SOURCE);
  options.offset = 0;
  options.shell = 0.25;
  const OwnedMesh shell = surfaceOf(field, grid, options);
  EXPECT_NEAR(closedVolumeOf(show(shell)), 1 - 0.125, 1e-6);
  auto fidelity = with(winding_fidelity_init);
  ASSERT_EQ(
    winding_compare(field.get(), shell.get(), 0.05, 1000, nullptr, &fidelity, nullptr), WINDING_OK);
  EXPECT_LT(fidelity.largest_shape_error, 1e-6);

  options.shell = 0;
  const OwnedMesh plain = surfaceOf(field, grid, options);
  EXPECT_EQ(show(plain).distances_from, WINDING_DISTANCES_FROM_NOTHING);
  ASSERT_EQ(
    winding_compare(field.get(), plain.get(), 0.05, 1000, nullptr, &fidelity, nullptr), WINDING_OK);
  EXPECT_TRUE(std::isnan(fidelity.largest_shape_error));

  const Field hollow =
    fieldOf(shapes::cube().with(shapes::cube({0.2, 0.2, 0.2}, {0.8, 0.8, 0.8}).reversed()));
  options.fill_cavities = 1;
  options.shell = 0.25;
  const OwnedMesh filled = surfaceOf(hollow, grid, options);
  EXPECT_NEAR(closedVolumeOf(show(filled)), 1 - 0.125, 1e-6);
  EXPECT_EQ(show(filled).filled_cavities, 1);
  EXPECT_EQ(show(filled).is_closed, 1);
  EXPECT_EQ(show(filled).part_count, 1);
  EXPECT_GT(show(filled).volume, show(filled).input_volume);
  EXPECT_EQ(show(filled).distances_from, WINDING_DISTANCES_FROM_SURFACE);

  Warnings told;
  options.shell = 0.01;
  surfaceOf(hollow, grid, options, &told.run);
  ASSERT_EQ(told.texts.size(), 1u);
  EXPECT_NE(told.texts[0].find("thinner than a voxel"), std::string::npos) << told.texts[0];
  for (const double wrong : {-1.0, std::nan("")})
  {
    options.shell = wrong;
    winding_mesh* mesh = nullptr;
    EXPECT_EQ(winding_level_surface(field.get(), &grid, nullptr, &options, nullptr, &mesh, nullptr),
      WINDING_REFUSED);
  }
}

TEST(LevelSurface, SaysThatItIsOpenAtTheBorder)
{
  const Field field = fieldOf(shapes::cube({0, 0, 0}, {9, 9, 9}));
  const winding_grid grid = gridAround({-1, -1, -1}, {5, 5, 5}, 8);
  Warnings told;
  auto options = with(winding_surface_options_init);
  options.mend_source = 0;
  const OwnedMesh open = surfaceOf(field, grid, options, &told.run);
  EXPECT_GT(show(open).polygon_count, 0);
  ASSERT_EQ(told.texts.size(), 1u);
  EXPECT_EQ(told.texts[0],
    "the surface reaches the border of the grid, where it is open: close the "
    "border (close_border = 1), or choose a larger grid (padding, sampling_bounds)");
  options.close_border = 1;
  const OwnedMesh closed = surfaceOf(field, grid, options, &told.run);
  EXPECT_GT(closedVolumeOf(show(closed)), 1);
  EXPECT_EQ(told.texts.size(), 1u) << told.texts.back();
}

TEST(LevelSurface, SaysWhyItIsEmpty)
{
  const Field field = fieldOf(shapes::cube({-9, -9, -9}, {9, 9, 9}));
  const winding_grid grid = gridAround({0, 0, 0}, {1, 1, 1}, 5);
  Warnings told;
  auto options = with(winding_surface_options_init);
  options.mend_source = 0;
  const OwnedMesh none = surfaceOf(field, grid, options, &told.run);
  EXPECT_EQ(show(none).polygon_count, 0);
  ASSERT_EQ(told.texts.size(), 1u);
  EXPECT_NE(told.texts[0].find("(close_border = 1)"), std::string::npos) << told.texts[0];
  options.close_border = 1;
  const OwnedMesh closed = surfaceOf(field, grid, options, &told.run);
  EXPECT_GT(closedVolumeOf(show(closed)), 1);

  winding_grid flat = grid;
  flat.dimensions[2] = 1;
  winding_mesh* mesh = nullptr;
  EXPECT_EQ(winding_level_surface(field.get(), &flat, nullptr, nullptr, nullptr, &mesh, nullptr),
    WINDING_REFUSED);
  EXPECT_EQ(mesh, nullptr);
}

TEST(Boolean, OfCubesHasTheirVolumes)
{
  const Field a = fieldOf(shapes::cube()),
              b = fieldOf(shapes::cube({0.5, 0.25, 0.25}, {2, 1.5, 2}));
  const winding_grid grid = gridAround({-0.3, -0.3, -0.3}, {2.3, 2.3, 2.3}, 30);
  const winding_field* const fields[] = {a.get(), b.get()};
  auto options = with(winding_surface_options_init);
  const double volumeOfB = 1.5 * 1.25 * 1.75, common = 0.5 * 0.75 * 0.75;
  const double expected[] = {
    1 + volumeOfB - common, common, 1 - common, 1 + volumeOfB - 2 * common};
  for (const int features : {WINDING_FEATURES_SMOOTH, WINDING_FEATURES_SHARP})
  {
    options.features = features;
    for (int operation = 0; operation < 4; ++operation)
    {
      winding_mesh* mesh = nullptr;
      winding_refusal refusal;
      ASSERT_EQ(
        winding_boolean(fields, 2, operation, &grid, nullptr, &options, nullptr, &mesh, &refusal),
        WINDING_OK)
        << refusal.text;
      const OwnedMesh owned(mesh, winding_mesh_free);
      const winding_mesh_arrays arrays = show(owned);
      const bool isExact = features == WINDING_FEATURES_SHARP && operation != WINDING_OPERATION_XOR;
      // Measured: 0.066 for smooth ones, whose edges are cut off.
      EXPECT_NEAR(closedVolumeOf(arrays), expected[operation], isExact ? 1e-5 : 0.1)
        << features << " " << operation;
      std::int64_t ofOperand[2] = {};
      for (std::int64_t i = 0; i < arrays.polygon_count; ++i)
      {
        ASSERT_TRUE(arrays.numbers[i] == 0 || arrays.numbers[i] == 1);
        ++ofOperand[arrays.numbers[i]];
      }
      EXPECT_GT(ofOperand[0], 50);
      EXPECT_GT(ofOperand[1], 50);
    }
  }
}

TEST(Boolean, HasARuleForEachSolidAndNeedsTwo)
{
  const Field a = fieldOf(shapes::cube()),
              b = fieldOf(shapes::cube({2, 0, 0}, {3, 1, 1}).reversed());
  const winding_grid grid = gridAround({-0.3, -0.3, -0.3}, {3.3, 1.3, 1.3}, 30);
  const winding_field* const fields[] = {a.get(), b.get()};
  winding_rule rules[] = {with(winding_rule_init), with(winding_rule_init)};
  auto options = with(winding_surface_options_init);
  options.features = WINDING_FEATURES_SHARP;
  const auto volumeOf = [&](int operation, std::vector<std::string>& texts)
  {
    Warnings told;
    winding_mesh* mesh = nullptr;
    EXPECT_EQ(
      winding_boolean(fields, 2, operation, &grid, rules, &options, &told.run, &mesh, nullptr),
      WINDING_OK);
    texts = told.texts;
    const OwnedMesh owned(mesh, winding_mesh_free);
    return closedVolumeOf(show(owned));
  };
  std::vector<std::string> texts;
  EXPECT_NEAR(volumeOf(WINDING_OPERATION_UNION, texts), 2, 1e-6);
  ASSERT_EQ(texts.size(), 1u); // the second one is turned
  options.mend_source = 0;
  EXPECT_NEAR(volumeOf(WINDING_OPERATION_UNION, texts), 1, 1e-6);
  ASSERT_EQ(texts.size(), 1u); // it is inside out
  rules[1].inside_rule = WINDING_INSIDE_RULE_ABSOLUTE;
  EXPECT_NEAR(volumeOf(WINDING_OPERATION_UNION, texts), 2, 1e-6);
  EXPECT_EQ(texts.size(), 0u);
  EXPECT_EQ(volumeOf(WINDING_OPERATION_INTERSECTION, texts), 0);
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_NE(texts[0].find("nothing is inside of the result"), std::string::npos) << texts[0];

  winding_mesh* mesh = nullptr;
  EXPECT_EQ(winding_boolean(
              fields, 1, WINDING_OPERATION_UNION, &grid, nullptr, nullptr, nullptr, &mesh, nullptr),
    WINDING_REFUSED);
  EXPECT_EQ(winding_boolean(fields, 2, 4, &grid, nullptr, nullptr, nullptr, &mesh, nullptr),
    WINDING_REFUSED);
  EXPECT_EQ(mesh, nullptr);
}

TEST(VoxelSurface, LiesBetweenLabels)
{
  const winding_grid grid = {{10, 0, 0}, {1, 2, 1}, {3, 1, 1}};
  const std::vector<std::uint16_t> labels = {7, 9, 0};
  winding_mesh* mesh = nullptr;
  ASSERT_EQ(
    winding_voxel_surface({labels.data(), 3, 0, WINDING_UINT16}, &grid, nullptr, &mesh, nullptr),
    WINDING_OK);
  const OwnedMesh owned(mesh, winding_mesh_free);
  const winding_mesh_arrays arrays = show(owned);
  EXPECT_EQ(arrays.polygon_count, 11);
  EXPECT_EQ(arrays.point_count, 12);
  int between = 0;
  for (std::int64_t i = 0; i < arrays.polygon_count; ++i)
  {
    between += arrays.labels[2 * i] != 0 && arrays.labels[2 * i + 1] != 0;
  }
  EXPECT_EQ(between, 1);
  EXPECT_EQ(pointOf(arrays, 0), Point(9.5, -1, -0.5));

  for (const winding_array& wrong : {winding_array{labels.data(), 2, 0, WINDING_UINT16},
         winding_array{labels.data(), 3, 0, WINDING_FLOAT32},
         winding_array{nullptr, 3, 0, WINDING_UINT8}})
  {
    EXPECT_EQ(winding_voxel_surface(wrong, &grid, nullptr, &mesh, nullptr), WINDING_MISUSED);
    EXPECT_EQ(mesh, nullptr);
  }
}

TEST(Files, AreReadWithNormalsAndNotes)
{
  const std::string folder = testing::TempDir();
  const auto read = [&](const std::string& name, const std::string& text, Warnings& told)
  {
    const std::string path = folder + "winding_c_" + name;
    std::ofstream(path) << text;
    winding_mesh* mesh = nullptr;
    winding_refusal refusal;
    const winding_status status = winding_read(path.c_str(), &told.run, &mesh, &refusal);
    std::remove(path.c_str());
    told.texts.emplace_back(refusal.text);
    EXPECT_EQ(mesh == nullptr, status != WINDING_OK);
    return OwnedMesh(mesh, winding_mesh_free);
  };
  Warnings told;
  const OwnedMesh square =
    read("square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n", told);
  EXPECT_EQ(show(square).point_count, 4);
  EXPECT_EQ(show(square).polygon_count, 1);
  EXPECT_EQ(show(square).corners[3], 3);

  const OwnedMesh named = read("named.obj",
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl red\nf 1 2 3\ng wing\nf 1 3 2\nf 1 2 3\n", told);
  ASSERT_EQ(show(named).regions_count, 1);
  auto regions = with(winding_regions_init);
  ASSERT_EQ(winding_mesh_regions(named.get(), 0, &regions, nullptr), WINDING_OK);
  EXPECT_STREQ(regions.kind, "Group");
  ASSERT_EQ(regions.count, 2);
  EXPECT_STREQ(regions.names[0], "");
  EXPECT_STREQ(regions.names[1], "wing");
  EXPECT_EQ(std::vector<std::int32_t>(regions.of_polygon, regions.of_polygon + 3),
    (std::vector<std::int32_t>{0, 1, 1}));
  EXPECT_EQ(winding_mesh_regions(named.get(), 1, &regions, nullptr), WINDING_MISUSED);

  const OwnedMesh points = read("points.xyz", "0 0 0 1 0 0\n1 2 3 0 1 0\n", told);
  EXPECT_EQ(show(points).point_count, 2);
  ASSERT_NE(show(points).point_normals, nullptr);
  EXPECT_EQ(show(points).offsets, nullptr);

  const OwnedMesh table = read("points.csv", "x,y,z,area\n1,2,3,4\n", told);
  ASSERT_NE(show(table).point_areas, nullptr);
  EXPECT_EQ(show(table).point_areas[0], 4);

  EXPECT_EQ(read("a.abc", "?", told), nullptr);
  EXPECT_NE(told.texts.back().find("suffix that is not known"), std::string::npos);
  EXPECT_EQ(read("a.off", "OFF\n3 1", told), nullptr);
  EXPECT_NE(told.texts.back().find("a.off"), std::string::npos) << told.texts.back();
}
