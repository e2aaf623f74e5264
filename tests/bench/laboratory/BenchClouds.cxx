// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "laboratory/BenchGrid.h"
#include "laboratory/BenchOptions.h"
#include "laboratory/BenchSubjects.h"
#include "laboratory/Measurement.h"
#include "laboratory/Meshes.h"
#include "laboratory/NaiveSums.h"
#include "laboratory/ThreadExecutor.h"
#include "program/Interrupt.h"
#include "program/Threads.h"

#include "base/Executor.h"
#include "base/Refusal.h"
#include "base/Views.h"
#include "source/PointCloud.h"
#include "source/Sanitize.h"
#include "source/Surface.h"

#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace
{

/// For each voxel, whether the surface is no farther than a voxel's side.
std::vector<unsigned char> nearVoxels(const Triangles& triangles, const winding::Grid& grid)
{
  const auto surface = polyDataOf(triangles);
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(surface);
  locator->BuildLocator();
  const winding::Extent extent = grid.wholeExtent();
  std::vector<unsigned char> isNear(winding::sampleCount(extent));
  const auto perSlice =
    static_cast<std::size_t>(grid.dimensions[0]) * static_cast<std::size_t>(grid.dimensions[1]);
  const auto lookAtSlice = [&](std::size_t slice)
  {
    vtkNew<vtkGenericCell> cell;
    for (std::size_t n = slice * perSlice; n < (slice + 1) * perSlice; ++n)
    {
      Eigen::Vector3d sample = grid.sample(n);
      double closest[3], squaredDistance;
      vtkIdType id;
      int part, inside;
      isNear[n] = locator->FindClosestPointWithinRadius(sample.data(), grid.spacing.maxCoeff(),
                    closest, cell, id, part, squaredDistance, inside) != 0;
    }
  };
  ThreadExecutor().run(isNear.size() / perSlice, lookAtSlice);
  interrupt::check();
  return isNear;
}

bool isInside(float w)
{
  return w >= 0.5f;
}

/// A row: the field of a cloud against the exact field of its mesh.
Json compare(const std::vector<unsigned char>& isNear, const Measurement& exact,
  const Measurement& cloud, Json row)
{
  std::size_t unlike = 0, unlikeFar = 0, far = 0;
  std::vector<float> farInside;
  for (std::size_t n = 0; n < isNear.size(); ++n)
  {
    const bool isUnlike = isInside(exact.values[n]) != isInside(cloud.values[n]);
    unlike += isUnlike;
    if (!isNear[n])
    {
      ++far;
      unlikeFar += isUnlike;
      if (isInside(exact.values[n]))
      {
        farInside.push_back(cloud.values[n]);
      }
    }
  }
  const auto percentOf = [](std::size_t part, std::size_t all)
  {
    return 100 * static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(all, 1));
  };
  row["unlike %"] = percentOf(unlike, isNear.size());
  row["unlike far %"] = percentOf(unlikeFar, far);
  row["median w inside"] = nullptr;
  if (!farInside.empty())
  {
    const auto middle = farInside.begin() + static_cast<std::ptrdiff_t>(farInside.size() / 2);
    std::nth_element(farInside.begin(), middle, farInside.end());
    row["median w inside"] = static_cast<double>(*middle);
  }
  row["prepare s"] = cloud.prepare;
  row["evaluate s"] = cloud.evaluate;
  return row;
}

void addRows(
  BenchTable& table, const Triangles& triangles, const winding::Surface& surface, int resolution)
{
  const winding::Grid grid = benchGrid(surface.bounds, resolution);
  const auto measureField = [&grid](const auto& views, const winding::FieldOptions& options)
  {
    const auto build = [&](winding::Executor& threads)
    {
      return winding::Field::build(views, options, threads);
    };
    return measure(build, grid);
  };
  const Measurement exact = measureField(std::vector{triangles.view()}, winding::FieldOptions());
  const std::vector<unsigned char> isNear = nearVoxels(triangles, grid);

  const winding::PointCloud vertices = verticesOf(surface);
  const std::size_t points = vertices.positions.size();
  const winding::OrientedPointsView cloud = {
    {vertices.positions[0].data(), points}, {vertices.normals[0].data(), points}, {}};
  winding::OrientedPointsView withAreas = cloud;
  withAreas.areas = {vertices.areas.data(), points};
  const double area = std::accumulate(vertices.areas.begin(), vertices.areas.end(), 0.0);
  winding::FieldOptions voronoi, constant;
  constant.pointAreaMethod = winding::PointAreaMethod::constant;
  for (const auto& [name, view, options] : {std::tuple("voronoi", cloud, voronoi),
         std::tuple("constant", cloud, constant), std::tuple("mesh", withAreas, voronoi)})
  {
    const Measurement measured = measureField(std::vector{view}, options);
    const winding::FieldInfo& info = measured.field->info();
    const double all = info.pointArea * static_cast<double>(info.primitives);
    // Digits beyond these are rounding.
    const double areaError = std::round(1e6 * (all / area - 1)) / 1e4;
    table.add(compare(isNear, exact, measured,
      {{"voxels", sizeOf(grid)}, {"areas", name}, {"area error %", areaError}}));
  }
}

} // namespace

std::vector<BenchTable> benchClouds(const BenchOptions& options, Messages& messages)
{
  std::vector<BenchTable> tables;
  const auto measureMesh = [&](const std::string& file, const Triangles& triangles)
  {
    ThreadExecutor executor;
    const winding::Surface surface = winding::sanitize({triangles.view()}, executor);
    if (surface.vertices.empty())
    {
      throw winding::Refusal("no triangle bounds anything");
    }
    const std::string title = file + ": " + std::to_string(surface.vertices.size()) + " points, " +
                              std::to_string(threadsUsed(options.threads)) + " threads";
    BenchTable table(title,
      {"the vertices as a cloud, with the normals of the triangles around them",
        "area error: of all areas together, against the mesh",
        "unlike: voxels on another side of w = 0.5 than in the field of the mesh; far: of those "
        "farther than a voxel from the surface",
        "median w inside: of the far ones inside the mesh"});
    for (const int resolution : givenOr(options.resolutions, {128}))
    {
      addRows(table, triangles, surface, resolution);
    }
    tables.push_back(table);
  };
  forEachMesh(options, messages, measureMesh);
  return tables;
}
