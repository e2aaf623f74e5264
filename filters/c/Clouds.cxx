// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Border.h"
#include "cloud/ConsistentNormals.h"
#include "cloud/OutwardNormals.h"
#include "cloud/PointAreas.h"
#include "source/MeshVertices.h"
#include "source/PointCloud.h"
#include "source/Sanitize.h"

#include <limits>

using namespace winding::c;
using winding::OrientedPointsView;
using winding::PointCloud;

namespace
{

/// Calls visit(point, n) for each point that is in the cloud, as its point n.
template <class Visit> void forEachKept(const OrientedPointsView& view, const Visit& visit)
{
  std::size_t kept = 0;
  for (std::size_t point = 0; point < view.positions.size(); ++point)
  {
    if (winding::isUsable(view, point))
    {
      visit(point, kept++);
    }
  }
}

winding::PointAreaOptions areasOf(const winding::FieldOptions& options)
{
  return {options.pointAreaMethod, options.pointArea, options.neighbors};
}

/// Writes the areas of a cloud's points, and NaN for points that are not in it.
void writeAreas(const OrientedPointsView& view, const std::vector<double>& from, double* to)
{
  std::fill(to, to + view.positions.size(), std::numeric_limits<double>::quiet_NaN());
  forEachKept(view, [&](std::size_t point, std::size_t n) { to[point] = from[n]; });
}

} // namespace

void winding_estimate_init(winding_estimate* estimate, size_t size)
{
  fill(estimate, size, winding_estimate());
}

winding_status winding_estimate_normals(winding_array points, const winding_options* options,
  const winding_run* run, float* normals, double* areas, winding_estimate* estimate,
  winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      OrientedPointsView view = {vectorsOf(points, "points"), {}, {}};
      const winding::FieldOptions wished = optionsOf(options);
      if (view.positions.empty())
      {
        if (estimate)
        {
          give(winding_estimate(), *estimate);
        }
        return;
      }
      float* const result = &required(normals, "normals");
      std::vector<float> directions;
      if (wished.lookAtViewpoints)
      {
        directions.assign(result, result + 3 * view.positions.size());
        view.normals = {directions.data(), view.positions.size()};
      }
      Call call(run);
      PointCloud cloud = winding::sanitize(std::vector<OrientedPointsView>{view}, call.executor);
      const winding::OutwardNormals found =
        winding::giveOutwardNormals(cloud, wished.normalEstimation,
          winding::Viewpoints(wished.toward), areasOf(wished), call.executor);
      if (found.isUnsure())
      {
        call.warn(winding::adviceOnNormals(found.orientation));
      }
      std::fill(result, result + 3 * view.positions.size(), 0.0F);
      forEachKept(view,
        [&](std::size_t point, std::size_t n)
        {
          for (int axis = 0; axis < 3; ++axis)
          {
            result[3 * point + static_cast<std::size_t>(axis)] =
              static_cast<float>(cloud.normals[n][axis]);
          }
        });
      if (areas)
      {
        writeAreas(view, cloud.areas, areas);
      }
      if (estimate)
      {
        winding_estimate to = {};
        to.normal_estimation = static_cast<int32_t>(found.estimation);
        to.clear_share = found.orientation.outward;
        give(to, *estimate);
      }
    });
}

winding_status winding_orient_normals(winding_array points, winding_array normals,
  const winding_run* run, uint8_t* turned, winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      const winding::VectorsView places = vectorsOf(points, "points"),
                                 directions = vectorsOf(normals, "normals");
      if (places.size() != directions.size())
      {
        throw Misuse("normals has other rows than points");
      }
      if (places.empty())
      {
        return;
      }
      uint8_t* const result = &required(turned, "turned");
      Call call(run);
      std::vector<Eigen::Vector3d> positions, vectors;
      for (std::size_t i = 0; i < places.size(); ++i)
      {
        positions.push_back(places[i]);
        vectors.push_back(directions[i]);
      }
      const std::vector<unsigned char> turns =
        winding::normalsToTurn(positions, vectors, call.executor);
      std::copy(turns.begin(), turns.end(), result);
    });
}

winding_status winding_point_areas(winding_array points, winding_array normals,
  const winding_options* options, const winding_run* run, double* areas, winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      const OrientedPointsView view = {
        vectorsOf(points, "points"), vectorsOf(normals, "normals"), {}};
      const winding::FieldOptions wished = optionsOf(options);
      if (view.positions.empty())
      {
        return;
      }
      double* const result = &required(areas, "areas");
      Call call(run);
      const PointCloud cloud =
        winding::sanitize(std::vector<OrientedPointsView>{view}, call.executor);
      if (cloud.normals.empty())
      {
        throw winding::Refusal(winding::missingNormals(!view.normals.empty()));
      }
      writeAreas(view, winding::pointAreas(cloud, areasOf(wished), call.executor), result);
    });
}

winding_status winding_vertices(winding_array points, const winding_polygons* polygons,
  const winding_run* run, double* normals, double* areas, winding_refusal* refusal)
{
  return guarded(run, refusal,
    [&]
    {
      const Triangles triangles(points, polygons);
      const std::size_t count = triangles.view().points.size();
      if (count > 0 && (!normals || !areas))
      {
        throw Misuse("normals or areas is null");
      }
      Call call(run);
      const winding::MeshVertices vertices =
        winding::meshVertices(triangles.views(), count, call.executor);
      for (std::size_t point = 0; point < count; ++point)
      {
        const Eigen::Vector3d normal = vertices.normals()[point];
        std::copy_n(normal.data(), 3, normals + 3 * point);
        areas[point] = vertices.areas()[point];
      }
    });
}
