#include "bench/BenchSubjects.h"
#include "bench/Measurement.h"
#include "bench/Meshes.h"
#include "bench/NaiveSums.h"
#include "bench/ThreadExecutor.h"
#include "input/ReadInput.h"
#include "options/Options.h"
#include "program/Threads.h"

#include "base/Bounds.h"
#include "base/Executor.h"
#include "base/Views.h"
#include "cloud/PointAreas.h"
#include "source/PointCloud.h"
#include "source/Sanitize.h"
#include "source/Surface.h"
#include "sums/ReferenceSum.h"

#include "vtkPointSet.h"

#include <filesystem>

namespace
{

enum class Kind
{
  rayCasting,
  mesh,
  cloud
};

/// A line of a published table: its mesh and time there, and the file of the mesh that stands for
/// it here.
struct Published
{
  Kind kind;
  const char* name;
  int resolution;
  double milliseconds;
  const char* file;
};

const Published publishedTimes[] = {
  {Kind::rayCasting, "Icosahedron (20)", 32, 139, "icosahedron.stl"},
  {Kind::rayCasting, "Sphere (960)", 32, 7123, "sphere_quads.obj"},
  {Kind::rayCasting, "Teapot (2464)", 32, 17659, "teapot.obj"},
  {Kind::rayCasting, "Bunny #1 (1000)", 32, 7279, "bunny_1k.obj"},
  {Kind::rayCasting, "Bunny #2 (10000)", 32, 71963, "bunny_10k.obj"},
  {Kind::rayCasting, "Bunny #3 (69664)", 32, 506532, "bunny_70k.obj"},
  {Kind::mesh, "Bunny #1 (1000)", 32, 7370, "bunny_1k.obj"},
  {Kind::mesh, "Bunny #1 (1000)", 64, 59277, "bunny_1k.obj"},
  {Kind::mesh, "Bunny #1 (1000)", 128, 471976, "bunny_1k.obj"},
  {Kind::mesh, "Teapot (2464)", 32, 17660, "teapot.obj"},
  {Kind::mesh, "Max (20196)", 32, 143033, "maxplanck_open_90k.obj"},
  {Kind::mesh, "Armadillo (345944)", 32, 2698200, "armadillo_346k_sub4.ply"},
  {Kind::cloud, "Bunny #1 (502)", 32, 444, "bunny_1k.obj"},
  {Kind::cloud, "Bunny #1 (502)", 64, 3462, "bunny_1k.obj"},
  {Kind::cloud, "Bunny #1 (502)", 128, 27852, "bunny_1k.obj"},
  {Kind::cloud, "Bunny #3 (34835)", 32, 30016, "bunny_70k.obj"},
  {Kind::cloud, "Teapot (1292)", 32, 1115, "teapot.obj"},
  {Kind::cloud, "Max (10227)", 32, 8777, "maxplanck_open_90k.obj"},
  {Kind::cloud, "Armadillo (172974)", 32, 150593, "armadillo_346k_sub4.ply"},
};

/// A grid with as many voxels along each axis, whatever the shape, as in the publication.
winding::Grid cubeOfVoxels(const winding::Bounds& bounds, int resolution)
{
  winding::GridRequest request;
  request.bounds = bounds;
  request.padding = 0.05;
  request.dimensions = Eigen::Vector3i::Constant(resolution);
  return winding::layOutGrid(request);
}

/// The columns that compare a naive evaluation, the measured one and the published one.
Json compare(double naive, const Measurement& measured, const winding::Grid& grid,
  double publishedMilliseconds)
{
  const double ours = 1e3 * (measured.prepare + measured.evaluate);
  return {{"naive ms", 1e3 * naive}, {"ours ms", ours},
    {"scaled", measured.isScaled ? "yes" : "no"},
    {"method", winding::nameOf(measured.field->info().method)},
    {"published/ours", publishedMilliseconds / ours}, {"naive/ours", 1e3 * naive / ours},
    {"max error", verified(measured, grid, 200).everywhere.max}};
}

Json measureMesh(
  const Published& published, const winding::Surface& surface, const Triangles& triangles)
{
  const winding::Grid grid = cubeOfVoxels(surface.bounds, published.resolution);
  double sum = 0; // the compiler may not leave out what adds to it
  const auto evaluateNaively = [&](const Eigen::Vector3d& sample)
  {
    sum += published.kind == Kind::rayCasting ? naiveParity(surface, sample)
                                              : winding::referenceSum<double>(surface, sample);
  };
  const double naive = scaledSeconds(grid, evaluateNaively);
  volatile double used = sum;
  (void)used;
  const auto build = [&](winding::Executor& executor)
  {
    return winding::Field::build({triangles.view()}, {}, executor);
  };
  const Measurement measured = measure(build, grid);
  Json row = {{"primitives here", surface.triangles.size()}};
  row.update(compare(naive, measured, grid, published.milliseconds));
  return row;
}

Json measureCloud(const Published& published, const winding::Surface& surface)
{
  const winding::Grid grid = cubeOfVoxels(surface.bounds, published.resolution);
  const winding::PointCloud cloud = verticesOf(surface);
  ThreadExecutor threads;
  const std::vector<double> areas =
    winding::pointAreas(cloud, {winding::PointAreaMethod::constant, 0}, threads);
  double sum = 0; // the compiler may not leave out what adds to it
  const auto evaluateNaively = [&](const Eigen::Vector3d& sample)
  {
    sum += winding::referenceSum<double>(cloud, areas, sample);
  };
  const double naive = scaledSeconds(grid, evaluateNaively);
  volatile double used = sum;
  (void)used;
  const winding::OrientedPointsView view = {{cloud.positions[0].data(), cloud.positions.size()},
    {cloud.normals[0].data(), cloud.normals.size()}, {}};
  const auto build = [&](winding::Executor& executor)
  {
    return winding::Field::build({view}, {}, executor);
  };
  const Measurement measured = measure(build, grid);
  Json row = {{"primitives here", cloud.positions.size()}};
  row.update(compare(naive, measured, grid, published.milliseconds));
  return row;
}

/// A row of a table; it has no times where the file is missing.
Json measureLine(const Published& published, const Options& options, Messages& messages)
{
  Json row = {{"published", published.name}, {"resolution", published.resolution},
    {"file", published.file}, {"published ms", published.milliseconds}};
  const std::string file = (std::filesystem::path(options.bench.data) / published.file).string();
  if (!std::filesystem::exists(file))
  {
    row["file"] = std::string(published.file) + " is missing";
    return row;
  }
  const Triangles triangles = trianglesOf(readInput(file, messages));
  winding::SerialExecutor executor;
  const winding::Surface surface = winding::sanitize({triangles.view()}, executor);
  row.update(published.kind == Kind::cloud ? measureCloud(published, surface)
                                           : measureMesh(published, surface, triangles));
  return row;
}

} // namespace

std::vector<BenchTable> benchSeed(const Options& options, Messages& messages)
{
  const std::string common = "published: ARM laptop, one thread; Max and Armadillo are repeated on "
                             "meshes like them, with other numbers of primitives";
  const auto naive = [](const std::string& what)
  {
    return "naive: " + what + ", one thread, measured at random voxels and scaled to all";
  };
  const std::string ours = "ours: winding::Field, method automatic, prepare and evaluate on " +
                           std::to_string(threadsUsed(options.threads)) +
                           " threads; scaled where all voxels would take more than 2 s";
  const std::string error = "max error: of w against the sum done term by term, at 200 voxels";
  std::vector<BenchTable> tables = {
    {"Ray casting", {common, naive("one ray-triangle test per triangle and voxel"), ours, error}},
    {"Winding number of a triangle mesh",
      {common, naive("one atan2 per triangle and voxel"), ours, error}},
    {"Winding number of a point cloud",
      {common + "; clouds are the vertices of the meshes, with one area for all",
        naive("one dipole per point and voxel"), ours, error}}};
  for (const Published& published : publishedTimes)
  {
    tables[static_cast<std::size_t>(published.kind)].add(measureLine(published, options, messages));
  }
  return tables;
}
