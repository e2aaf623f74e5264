// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Border.h"
#include "report/Advice.h"
#include "report/SurfaceExamination.h"

#include <limits>

using namespace winding::c;

namespace
{

/// Stands for a figure that cannot be had.
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Writes the least coordinates of a box, and then the largest.
void writeBox(const winding::Bounds& bounds, double* box)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    box[axis] = bounds.isEmpty() ? missing : bounds.min()[axis];
    box[axis + 3] = bounds.isEmpty() ? missing : bounds.max()[axis];
  }
}

} // namespace

void winding_report_init(winding_report* report, size_t size)
{
  fill(report, size, winding_report());
}

winding_status winding_examine(winding_array points, const winding_polygons* polygons,
  const winding_run* run, winding_report* report, winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      winding_report& result = required(report, "report");
      const Triangles triangles(points, polygons);
      Call call(run);
      const winding::SurfaceExamination found =
        winding::examineSurface(triangles.views(), {triangles.view().points}, call.executor);
      const winding::Surface& surface = *found.field->surface();
      const winding::EdgeCounts& edges = found.report.edges;
      const winding::OrientationCounts& orientation = found.report.orientation;
      call.warn(winding::adviceOn(surface, found.report));
      winding_report to = {};
      to.closed = edges.isClosed() && !surface.triangles.empty();
      to.triangles = static_cast<int64_t>(surface.inputTriangles);
      to.vertices = static_cast<int64_t>(found.vertices.points);
      to.vertices_merged = static_cast<int64_t>(found.vertices.different);
      to.edges = static_cast<int64_t>(edges.edges);
      to.boundary_edges = static_cast<int64_t>(edges.boundary);
      to.boundary_loops = static_cast<int64_t>(edges.boundaryLoops);
      to.nonmanifold_edges = static_cast<int64_t>(edges.nonManifold);
      to.inconsistent_edges = static_cast<int64_t>(edges.inconsistent);
      to.net_boundary_edges = static_cast<int64_t>(edges.netBoundary);
      to.components_vertex = static_cast<int64_t>(found.report.vertexComponents);
      to.components_edge = static_cast<int64_t>(edges.components);
      to.closed_components = static_cast<int64_t>(orientation.closed);
      to.inverted_components = static_cast<int64_t>(orientation.inverted);
      to.nested_solids = static_cast<int64_t>(orientation.nestedSolids);
      to.one_sided_components = static_cast<int64_t>(orientation.oneSided);
      to.open_parts_inside = static_cast<int64_t>(found.report.openPartsInside);
      to.duplicate_faces = static_cast<int64_t>(found.report.duplicateTriangles);
      to.degenerate = static_cast<int64_t>(surface.collapsedTriangles);
      to.zero_area = static_cast<int64_t>(found.report.zeroAreaTriangles);
      to.unreferenced_vertices = static_cast<int64_t>(found.vertices.unreferenced);
      to.euler = static_cast<int64_t>(found.report.eulerCharacteristic);
      to.volume = found.report.volume;
      to.area = found.report.area;
      to.fractional_share = found.fractionalShare.value_or(missing);
      writeBox(surface.bounds, to.bbox);
      to.non_finite = static_cast<int64_t>(surface.nonFiniteTriangles);
      to.invalid_ids = static_cast<int64_t>(surface.invalidIdTriangles);
      to.widest_slit = found.report.widestSlit.value_or(missing);
      give(to, result);
    });
}

void winding_cloud_report_init(winding_cloud_report* report, size_t size)
{
  fill(report, size, winding_cloud_report());
}

winding_status winding_examine_points(winding_array points, winding_array normals,
  const winding_run* run, winding_cloud_report* report, winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      winding_cloud_report& result = required(report, "report");
      const winding::OrientedPointsView view = {
        vectorsOf(points, "points"), vectorsOf(normals, "normals"), {}};
      Call call(run);
      const winding::CloudReport found = winding::reportOn({view}, call.executor);
      call.warn(winding::adviceOn(found));
      winding_cloud_report to = {};
      to.normals = found.hasNormals;
      to.points = static_cast<int64_t>(found.points);
      to.duplicates = static_cast<int64_t>(found.duplicates);
      to.zero_normals = static_cast<int64_t>(found.zeroNormals);
      to.non_unit_normals = static_cast<int64_t>(found.nonUnitNormals);
      to.non_finite = static_cast<int64_t>(found.nonFinite);
      to.spacing_min = found.spacing.smallest;
      to.spacing_median = found.spacing.median;
      to.spacing_mean = found.spacing.mean;
      to.spacing_max = found.spacing.largest;
      to.opposite_neighbors = found.oppositeNeighbors;
      to.w_behind = to.w_before = to.outward_share = to.inward_share = missing;
      if (found.orientation)
      {
        to.w_behind = found.orientation->behind;
        to.w_before = found.orientation->before;
        to.outward_share = found.orientation->outward;
        to.inward_share = found.orientation->inward;
      }
      writeBox(found.bounds, to.bbox);
      give(to, result);
    });
}
