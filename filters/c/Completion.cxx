// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Border.h"
#include "Handles.h"
#include "messages/PropertyChecks.h"
#include "source/SnappedPoints.h"
#include "surface/CompletedSurface.h"

#include <algorithm>
#include <cstdint>
#include <vector>

using namespace winding::c;

winding_status winding_weld(winding_array points, double tolerance, const winding_run* run,
  double* welded, winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      const winding::VectorsView given = vectorsOf(points, "points");
      winding::checkProperty(winding::Parameter::weldTolerance, tolerance);
      if (!given.empty())
      {
        required(welded, "welded");
      }
      Call call(run);
      const std::vector<double> moved =
        winding::snappedPoints({given}, tolerance, call.executor).front();
      std::copy(moved.begin(), moved.end(), welded);
    });
}

winding_status winding_complete(winding_array points, const winding_polygons* polygons,
  const winding_options* options, const winding_run* run, winding_mesh** mesh,
  winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      required(mesh, "mesh") = nullptr;
      const winding::FieldOptions wished = optionsOf(options);
      Triangles triangles(points, polygons);
      Call call(run);
      triangles.weld(wished.weldTolerance, call.executor);
      giveHandle(*mesh,
        [&](winding_mesh& made)
        {
          const winding::CompletedSurface completed = winding::completedSurface(triangles.views(),
            winding::Mirror(wished.mirror, wished.weldTolerance),
            winding::FlatBase(wished.flatBase), call.executor);
          call.warn(completed.notes);
          const winding::Surface& surface = completed.surface;
          made.offsets.push_back(0);
          for (const winding::Triangle& t : surface.triangles)
          {
            made.corners.insert(made.corners.end(), t.begin(), t.end());
            made.offsets.push_back(static_cast<std::int64_t>(made.corners.size()));
          }
          for (const Eigen::Vector3d& vertex : surface.vertices)
          {
            made.doublePoints.insert(made.doublePoints.end(), vertex.data(), vertex.data() + 3);
          }
        });
    });
}

winding_status winding_complete_bounds(
  const winding_options* options, double* bounds, winding_refusal* refusal)
{
  return guarded(nullptr, refusal,
    [&]
    {
      const winding::FieldOptions wished = optionsOf(options);
      required(bounds, "bounds");
      const winding::Bounds given(Eigen::Vector3d(bounds[0], bounds[2], bounds[4]),
        Eigen::Vector3d(bounds[1], bounds[3], bounds[5]));
      const winding::Bounds completed =
        winding::FlatBase(wished.flatBase)
          .completed(winding::Mirror(wished.mirror).completed(given));
      for (int axis = 0; axis < 3 && !given.isEmpty(); ++axis)
      {
        bounds[2 * axis] = completed.min()[axis];
        bounds[2 * axis + 1] = completed.max()[axis];
      }
    });
}
