// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Calls.h"
#include "files/TemporaryFile.h"

#include <algorithm>
#include <utility>

namespace calls
{

/// Everything that a call needs, right at first; what it makes is given back with it.
struct Arguments
{
  Arguments()
    : mesh(shapes::icosphere(1))
    , field(fieldOf(mesh))
    , polygons(polygonsOf(mesh))
    , grid(gridAround({-1, -1, -1}, {1, 1, 1}, 6))
    , points(arrayOf(mesh.points))
    , floats(sizeOf(grid))
    , doubles(3 * sizeOf(grid))
    , areas(mesh.points.size())
    , nearest(mesh.points.size())
    , bytes(sizeOf(grid))
    , labels(sizeOf(grid))
    , solids(mesh.triangles.size())
    , values(with(winding_values_init))
    , rule(with(winding_rule_init))
    , options(with(winding_options_init))
    , run(with(winding_run_init))
    , meshFile("o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\no b\nf 1 4 3\nf 2 3 4\n",
        ".obj")
    , tableFile("x,y,z,nx,ny,nz,mark\n1,2,3,1,0,0,9\n4,5,6,0,1,0,8\n", ".csv")
    , readMesh(nullptr, winding_mesh_free)
    , readTable(nullptr, winding_mesh_free)
  {
    EXPECT_EQ(winding_read(meshFile.name(), nullptr, &madeMesh, nullptr), WINDING_OK);
    readMesh.reset(std::exchange(madeMesh, nullptr));
    EXPECT_EQ(winding_read_table(tableFile.name(), 1, nullptr, &madeMesh, nullptr), WINDING_OK);
    readTable.reset(std::exchange(madeMesh, nullptr));
    values.winding = floats.data();
    values.inside = bytes.data();
    run.number_of_threads = 2;
    skin.points = points;
    skin.polygons = {
      {faceCorners.data(), 3, 0, WINDING_INT64}, {faceOffsets.data(), 2, 0, WINDING_INT64}};
    skin.owners = {owners.data(), 1, 0, WINDING_INT64};
    outwardCorners.resize(3);
    outwardOffsets.resize(2);
    outwardPolygons.resize(1);
    cellCounts = with(winding_cell_counts_init);
  }
  ~Arguments() { this->release(); }
  Arguments(const Arguments&) = delete;
  void operator=(const Arguments&) = delete;

  /// Gives back what a call has made.
  void release()
  {
    winding_field_free(std::exchange(madeField, nullptr));
    winding_mesh_free(std::exchange(madeMesh, nullptr));
  }

  shapes::Mesh mesh;
  Field field;
  winding_polygons polygons;
  winding_grid grid;
  winding_array points;
  std::vector<float> floats;
  std::vector<double> doubles, areas;
  std::vector<std::int64_t> nearest;
  std::vector<std::uint8_t> bytes;
  std::vector<std::uint16_t> labels;
  std::vector<std::int32_t> solids;
  winding_values values;
  winding_rule rule;
  winding_options options;
  winding_run run;
  std::vector<std::uint8_t> types = {10, 42};
  std::vector<std::int64_t> corners = {
    0, 1, 2, 3, 4, 3, 0, 2, 1, 3, 0, 1, 3, 3, 1, 2, 3, 3, 2, 0, 3};
  std::vector<std::int64_t> offsets = {0, 4, 21};
  winding_cells cells = {{types.data(), 2, 0, WINDING_UINT8},
    {corners.data(), 21, 0, WINDING_INT64}, {offsets.data(), 3, 0, WINDING_INT64}};
  /// The first face of the tetrahedron.
  winding_skin skin = {};
  std::vector<std::int64_t> faceCorners = {0, 2, 1}, faceOffsets = {0, 3}, owners = {0};
  std::vector<std::int64_t> outwardCorners, outwardOffsets, outwardPolygons;
  winding_cell_counts cellCounts;
  TemporaryFile meshFile, tableFile;
  OwnedMesh readMesh, readTable;
  winding_field* madeField = nullptr;
  winding_mesh* madeMesh = nullptr;
  winding_refusal refusal = {};
};

struct Call
{
  const char* name;
  winding_status (*make)(Arguments& with);
};

/// Every function that returns a status, with arguments that are right.
inline const Call allCalls[] = {
  {"winding_faces",
    [](Arguments& a)
    {
      return winding_faces(a.points, &a.polygons, &a.options, &a.run, &a.madeField, &a.refusal);
    }},
  {"winding_points",
    [](Arguments& a)
    {
      return winding_points(
        a.points, a.points, {nullptr, 0, 0, 0}, &a.options, &a.run, &a.madeField, &a.refusal);
    }},
  {"winding_evaluate_grid",
    [](Arguments& a)
    {
      return winding_evaluate_grid(
        a.field.get(), &a.grid, nullptr, &a.rule, &a.values, &a.run, &a.refusal);
    }},
  {"winding_evaluate_points",
    [](Arguments& a)
    {
      return winding_evaluate_points(
        a.field.get(), a.points, &a.rule, &a.values, &a.run, &a.refusal);
    }},
  {"winding_cell_fractions",
    [](Arguments& a)
    {
      return winding_cell_fractions(
        a.field.get(), a.points, &a.cells, &a.rule, a.floats.data(), &a.run, &a.refusal);
    }},
  {"winding_check_cells",
    [](Arguments& a)
    {
      return winding_check_cells(
        &a.cells, nullptr, {nullptr, 0, 0, 0}, 2, a.points.rows, 0, "the mesh", &a.refusal);
    }},
  {"winding_choose_cells",
    [](Arguments& a)
    {
      return winding_choose_cells(
        a.cells.types, nullptr, 0, a.bytes.data(), &a.cellCounts, &a.refusal);
    }},
  {"winding_halvings",
    [](Arguments& a)
    {
      std::int32_t halvings;
      return winding_halvings(&a.skin, &a.skin, 2, 1, &halvings, &a.cellCounts, &a.refusal);
    }},
  {"winding_outward_polygons",
    [](Arguments& a)
    {
      std::int64_t kept;
      return winding_outward_polygons(a.points, &a.cells, &a.skin, a.outwardCorners.data(),
        a.outwardOffsets.data(), a.outwardPolygons.data(), &kept, &a.cellCounts, &a.refusal);
    }},
  {"winding_sentence",
    [](Arguments& a)
    {
      char text[1000];
      const char* const values[] = {"5", "7"};
      return winding_sentence("queriesNotFinite", values, 2, &a.run, text, sizeof text, &a.refusal);
    }},
  {"winding_warn_of_cells",
    [](Arguments& a)
    {
      return winding_warn_of_cells(&a.cellCounts, &a.run, &a.refusal);
    }},
  {"winding_level_surface",
    [](Arguments& a)
    {
      return winding_level_surface(
        a.field.get(), &a.grid, &a.rule, nullptr, &a.run, &a.madeMesh, &a.refusal);
    }},
  {"winding_boolean",
    [](Arguments& a)
    {
      const winding_field* const fields[] = {a.field.get(), a.field.get()};
      const winding_rule rules[] = {a.rule, a.rule};
      return winding_boolean(fields, 2, WINDING_OPERATION_UNION, &a.grid, rules, nullptr, &a.run,
        &a.madeMesh, &a.refusal);
    }},
  {"winding_voxel_surface",
    [](Arguments& a)
    {
      return winding_voxel_surface(
        {a.bytes.data(), static_cast<int64_t>(a.bytes.size()), 0, WINDING_UINT8}, &a.grid, &a.run,
        &a.madeMesh, &a.refusal);
    }},
  {"winding_label",
    [](Arguments& a)
    {
      const winding_field* fields[] = {a.field.get()};
      auto arrays = with(winding_labels_init);
      arrays.labels = a.labels.data();
      return winding_label(
        fields, nullptr, 1, &a.grid, nullptr, &a.rule, nullptr, &arrays, &a.run, &a.refusal);
    }},
  {"winding_solids",
    [](Arguments& a)
    {
      std::int64_t count;
      return winding_solids(a.points, &a.polygons, &a.run, a.solids.data(), &count, &a.refusal);
    }},
  {"winding_open_parts",
    [](Arguments& a)
    {
      return winding_open_parts(a.points, &a.polygons, &a.run, a.bytes.data(), &a.refusal);
    }},
  {"winding_nearest",
    [](Arguments& a)
    {
      return winding_nearest(a.points, &a.polygons, &a.options, a.points, a.nearest.data(), nullptr,
        nullptr, &a.run, &a.refusal);
    }},
  {"winding_faults",
    [](Arguments& a)
    {
      return winding_faults(
        a.points, &a.polygons, WINDING_FAULT_CAPS, &a.run, &a.madeMesh, &a.refusal);
    }},
  {"winding_vertices",
    [](Arguments& a)
    {
      return winding_vertices(
        a.points, &a.polygons, &a.run, a.doubles.data(), a.areas.data(), &a.refusal);
    }},
  {"winding_verify",
    [](Arguments& a)
    {
      auto found = with(winding_verification_init);
      const auto samples = static_cast<std::int64_t>(a.floats.size());
      return winding_verify(a.field.get(), &a.grid, nullptr,
        {a.floats.data(), samples, 0, WINDING_FLOAT32}, 10, &a.run, &found, &a.refusal);
    }},
  {"winding_weld",
    [](Arguments& a)
    {
      return winding_weld(a.points, 0.01, &a.run, a.doubles.data(), &a.refusal);
    }},
  {"winding_complete",
    [](Arguments& a)
    {
      return winding_complete(a.points, &a.polygons, &a.options, &a.run, &a.madeMesh, &a.refusal);
    }},
  {"winding_complete_bounds",
    [](Arguments& a)
    {
      double bounds[6] = {0, 1, 0, 1, 0, 1};
      return winding_complete_bounds(&a.options, bounds, &a.refusal);
    }},
  {"winding_examine",
    [](Arguments& a)
    {
      auto report = with(winding_report_init);
      return winding_examine(a.points, &a.polygons, &a.run, &report, &a.refusal);
    }},
  {"winding_orient",
    [](Arguments& a)
    {
      return winding_orient(a.points, &a.polygons, &a.run, a.bytes.data(),
        a.bytes.data() + a.bytes.size() / 2, nullptr, nullptr, &a.refusal);
    }},
  {"winding_examine_points",
    [](Arguments& a)
    {
      auto report = with(winding_cloud_report_init);
      return winding_examine_points(a.points, a.points, &a.run, &report, &a.refusal);
    }},
  {"winding_orient_normals",
    [](Arguments& a)
    {
      return winding_orient_normals(a.points, a.points, &a.run, a.bytes.data(), &a.refusal);
    }},
  {"winding_estimate_normals",
    [](Arguments& a)
    {
      return winding_estimate_normals(
        a.points, &a.options, &a.run, a.floats.data(), nullptr, nullptr, &a.refusal);
    }},
  {"winding_point_areas",
    [](Arguments& a)
    {
      return winding_point_areas(
        a.points, a.points, &a.options, &a.run, a.doubles.data(), &a.refusal);
    }},
  {"winding_describe",
    [](Arguments& a)
    {
      auto info = with(winding_field_info_init);
      return winding_describe(a.field.get(), &info, &a.refusal);
    }},
  {"winding_expect_memory",
    [](Arguments& a)
    {
      std::int64_t bytes;
      return winding_expect_memory(a.field.get(), 1000, 1, &bytes, &a.refusal);
    }},
  {"winding_expect_surface",
    [](Arguments& a)
    {
      double bytes;
      return winding_expect_surface(
        a.field.get(), &a.grid, nullptr, nullptr, &a.run, &bytes, &a.refusal);
    }},
  {"winding_measure",
    [](Arguments& a)
    {
      double area, volume;
      return winding_measure(a.field.get(), &area, &volume, &a.refusal);
    }},
  {"winding_lay_out_grid",
    [](Arguments& a)
    {
      const auto request = requestAround({0, 0, 0}, {1, 1, 1});
      winding_grid grid;
      return winding_lay_out_grid(&request, &a.run, &grid, &a.refusal);
    }},
  {"winding_wall_resolution",
    [](Arguments& a)
    {
      const auto request = requestAround({0, 0, 0}, {1, 1, 1});
      int32_t resolution;
      char reason[200];
      return winding_wall_resolution(a.field.get(), &request, &a.rule, 1, &a.run, &resolution,
        reason, sizeof reason, &a.refusal);
    }},
  {"winding_read",
    [](Arguments& a)
    {
      return winding_read(a.meshFile.name(), &a.run, &a.madeMesh, &a.refusal);
    }},
  {"winding_read_columns",
    [](Arguments& a)
    {
      return winding_read_columns(
        a.tableFile.name(), "x=nx y=ny z=nz nx=x ny=y nz=3", &a.run, &a.madeMesh, &a.refusal);
    }},
  {"winding_read_table",
    [](Arguments& a)
    {
      return winding_read_table(a.tableFile.name(), 1, &a.run, &a.madeMesh, &a.refusal);
    }},
  {"winding_mesh_show",
    [](Arguments& a)
    {
      auto arrays = with(winding_mesh_arrays_init);
      return winding_mesh_show(a.readMesh.get(), &arrays, &a.refusal);
    }},
  {"winding_mesh_column",
    [](Arguments& a)
    {
      auto column = with(winding_column_init);
      return winding_mesh_column(a.readTable.get(), 0, &column, &a.refusal);
    }},
  {"winding_mesh_regions",
    [](Arguments& a)
    {
      auto regions = with(winding_regions_init);
      return winding_mesh_regions(a.readMesh.get(), 0, &regions, &a.refusal);
    }},
  {"winding_compare",
    [](Arguments& a)
    {
      auto fidelity = with(winding_fidelity_init);
      return winding_compare(
        a.field.get(), a.readMesh.get(), 0.4, 50, &a.run, &fidelity, &a.refusal);
    }},
};

} // namespace calls
