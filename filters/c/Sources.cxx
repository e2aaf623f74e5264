// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Border.h"
#include "Handles.h"
#include "diagnosis/Diagnosis.h"
#include "field/FieldVolume.h"
#include "source/MeshVertices.h"

using namespace winding::c;
using winding::Field;
using winding::FieldOptions;

namespace
{

/// Makes a field of views, and warns of what it found.
template <class View>
void buildField(const std::vector<View>& views, const winding_options* options,
  const winding_run* run, winding_field*& to)
{
  Call call(run);
  giveHandle(to,
    [&](winding_field& handle)
    {
      handle.field = Field::build(views, optionsOf(options), call.executor);
      call.warn(handle.field->info().warnings);
      call.warn(handle.field->diagnosis().ofSource(call.executor));
      if (handle.field->info().primitives == 0)
      {
        call.warn(winding::emptySourceAdvice(known(options, defaultOptions()).weld_tolerance > 0));
      }
    });
}

} // namespace

int32_t winding_abi(void)
{
  return WINDING_ABI;
}

const char* winding_version(void)
{
  return WINDING_VERSION;
}

void winding_run_init(winding_run* run, size_t size)
{
  fill(run, size, defaultRun());
}

void winding_options_init(winding_options* options, size_t size)
{
  fill(options, size, defaultOptions());
}

winding_status winding_faces(winding_array points, const winding_polygons* polygons,
  const winding_options* options, const winding_run* run, winding_field** field,
  winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      required(field, "field") = nullptr;
      Triangles triangles(points, polygons);
      const double tolerance = toleranceOf(options);
      if (tolerance > 0)
      {
        Call call(run);
        triangles.weld(tolerance, call.executor);
      }
      if (known(options, defaultOptions()).source_as_points)
      {
        Call call(run);
        const winding::VectorsView positions = triangles.view().points;
        const winding::MeshVertices vertices =
          winding::meshVertices(triangles.views(), positions.size(), call.executor);
        const std::vector<winding::OrientedPointsView> views = {
          {positions, vertices.normals(), {}}};
        buildField(views, options, run, *field);
        return;
      }
      buildField(triangles.views(), options, run, *field);
    });
}

winding_status winding_points(winding_array points, winding_array normals, winding_array areas,
  const winding_options* options, const winding_run* run, winding_field** field,
  winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      required(field, "field") = nullptr;
      const std::vector<winding::OrientedPointsView> views = {
        {vectorsOf(points, "points"), vectorsOf(normals, "normals"), scalarsOf(areas, "areas")}};
      buildField(views, options, run, *field);
    });
}

void winding_field_free(winding_field* field)
{
  delete field;
}

void winding_field_info_init(winding_field_info* info, size_t size)
{
  fill(info, size, winding_field_info());
}

winding_status winding_describe(
  const winding_field* field, winding_field_info* info, winding_refusal* refusal)
{
  return guarded(nullptr, refusal,
    [&]
    {
      const Field& source = *required(field, "field").field;
      const winding::FieldInfo& known = source.info();
      winding_field_info found = {};
      found.method = static_cast<int32_t>(known.method);
      found.is_surface = known.isSurface;
      found.normals_estimated = known.normalsAreEstimated;
      found.primitives = static_cast<int64_t>(known.primitives);
      found.dropped = static_cast<int64_t>(known.dropped);
      found.boundary_edges = static_cast<int64_t>(known.boundaryEdges);
      found.net_boundary_edges = static_cast<int64_t>(known.netBoundaryEdges);
      giveBounds(known.bounds, found.bounds);
      found.mean_point_area = known.pointArea;
      if (known.normalsAreEstimated)
      {
        found.clear_share = known.orientation.outward;
        found.normal_estimation = static_cast<int32_t>(known.normalEstimation);
      }
      winding::SerialExecutor serial;
      found.has_no_sides = field->field->diagnosis().hasNoSides(serial);
      found.is_wide_open = known.openings.areWide();
      copyText(known.why, found.reason, sizeof found.reason);
      give(found, required(info, "info"));
    });
}

winding_status winding_expect_memory(const winding_field* field, int64_t samples,
  int32_t with_distances, int64_t* bytes, winding_refusal* refusal)
{
  return guarded(nullptr, refusal,
    [&]
    {
      const Field& source = *required(field, "field").field;
      if (samples < 0)
      {
        throw Misuse("samples are less than 0");
      }
      const auto count = static_cast<std::size_t>(samples);
      std::size_t expected = source.expectedBytes(count);
      expected += with_distances ? source.expectedBytesOfDistances(count) : 0;
      required(bytes, "bytes") = static_cast<int64_t>(expected);
    });
}

winding_status winding_measure(
  const winding_field* field, double* area, double* volume, winding_refusal* refusal)
{
  return guarded(nullptr, refusal,
    [&]
    {
      const Field& source = *required(field, "field").field;
      if (area)
      {
        *area = source.area();
      }
      if (volume)
      {
        *volume = winding::volumeOf(source);
      }
    });
}
