#include "bench/BenchGrid.h"
#include "bench/BenchSubjects.h"
#include "bench/Measurement.h"
#include "bench/Meshes.h"
#include "bench/ThreadExecutor.h"
#include "bench/Timing.h"
#include "options/Options.h"
#include "program/Threads.h"

#include "base/Executor.h"
#include "base/Views.h"
#include "rays/RowTriangle.h"
#include "source/Sanitize.h"
#include "source/Surface.h"
#include "surface/Cap.h"

#include <cmath>
#include <numeric>
#include <optional>

namespace
{

/// How often the rows of a grid cross a surface and its cap together.
std::size_t countCrossings(const winding::Surface& surface, const winding::Grid& grid)
{
  winding::SerialExecutor executor;
  const winding::TriangleList cap = winding::capOf(
    boundaryLoops(boundaryChain(surface, executor).edges, surface.vertices.size(), executor));
  winding::TriangleList chain = surface.triangles;
  chain.insert(chain.end(), cap.begin(), cap.end());
  const auto inGrid = [&](std::int32_t id) -> Eigen::Vector3d
  {
    return (surface.vertices[static_cast<std::size_t>(id)] - grid.firstSample)
      .cwiseQuotient(grid.spacing);
  };
  constexpr std::size_t block = 1024;
  std::vector<std::size_t> counts((chain.size() + block - 1) / block);
  const auto countBlock = [&](std::size_t number)
  {
    for (std::size_t i = number * block; i < std::min(chain.size(), (number + 1) * block); ++i)
    {
      const Eigen::Vector3d a = inGrid(chain[i][0]);
      const Eigen::Vector3d b = inGrid(chain[i][1]);
      const Eigen::Vector3d c = inGrid(chain[i][2]);
      const winding::RowTriangle triangle(a, b, c);
      const double low = std::max(0.0, std::ceil(std::min({a[2], b[2], c[2]})));
      const double high =
        std::min(grid.dimensions[2] - 1.0, std::floor(std::max({a[2], b[2], c[2]})));
      for (int k = static_cast<int>(low); k <= high; ++k)
      {
        const winding::RowTriangle::Range range = triangle.rowsIn(k, 0, grid.dimensions[1] - 1);
        for (int j = range.first; j <= range.last; ++j)
        {
          counts[number] += triangle.crossingSign(j, k) != 0;
        }
      }
    }
  };
  ThreadExecutor().run(counts.size(), countBlock);
  return std::accumulate(counts.begin(), counts.end(), std::size_t(0));
}

Json rowOf(const Measurement& measured, const winding::Grid& grid, double fill, int threads)
{
  const winding::FieldInfo& info = measured.field->info();
  const std::size_t samples = winding::sampleCount(grid.wholeExtent());
  const double seconds = measured.prepare + measured.evaluate;
  const double expected = measured.field->expectedCost(samples).seconds / threads;
  const winding::Verification errors = verified(measured, grid, 500);
  const auto errorOf = [](const winding::ErrorStatistics& found, double error)
  {
    return found.samples > 0 ? Json(error) : Json(nullptr);
  };
  return {{"method", winding::nameOf(info.method)}, {"prepare s", measured.prepare},
    {"evaluate s", measured.evaluate}, {"scaled", measured.isScaled ? "yes" : "no"},
    {"expected s", expected}, {"times expected", seconds / expected},
    {"ns/voxel", 1e9 * measured.evaluate / static_cast<double>(samples)}, {"crossings", nullptr},
    {"boundary edges", info.netBoundaryEdges}, {"cap triangles", nullptr},
    {"max error", errorOf(errors.everywhere, errors.everywhere.max)},
    {"RMS error", errorOf(errors.everywhere, errors.everywhere.rms())},
    {"near max error", errorOf(errors.nearSurface, errors.nearSurface.max)}, {"fill s", fill},
    {"times fill", seconds / fill}};
}

void addRows(BenchTable& table, const winding::TrianglesView& view, const winding::Surface& surface,
  int resolution, int threads)
{
  const winding::Grid grid = benchGrid(surface.bounds, resolution);
  const double fill = secondsToFill(winding::sampleCount(grid.wholeExtent()));
  std::optional<winding::Method> chosen; // the method that automatic chooses
  for (const winding::Method method : {winding::Method::automatic, winding::Method::hierarchical,
         winding::Method::direct, winding::Method::parity})
  {
    if (method == chosen)
    {
      continue; // automatic was measured first
    }
    winding::FieldOptions options;
    options.method = method;
    const auto build = [&](winding::Executor& executor)
    {
      return winding::Field::build({view}, options, executor);
    };
    const Measurement measured = measure(build, grid);
    Json row = {{"voxels", sizeOf(grid)}};
    row.update(rowOf(measured, grid, fill, threads));
    if (measured.field->info().method == winding::Method::rows)
    {
      row["crossings"] = countCrossings(surface, grid);
      row["cap triangles"] = measured.field->info().capTriangles;
    }
    if (method == winding::Method::automatic)
    {
      chosen = measured.field->info().method;
    }
    table.add(row);
  }
}

} // namespace

std::vector<BenchTable> benchFiles(const Options& options, Messages& messages)
{
  std::vector<BenchTable> tables;
  const auto measureMesh = [&](const std::string& file, const Triangles& triangles)
  {
    winding::SerialExecutor executor;
    const winding::Surface surface = winding::sanitize({triangles.view()}, executor);
    const int threads = threadsUsed(options.threads);
    const std::string title = file + ": " + std::to_string(surface.triangles.size()) +
                              " triangles, " + std::to_string(threads) + " threads";
    BenchTable table(title,
      {"the first method of each size is the one that automatic chooses",
        "scaled: measured at random voxels; all of them would take more than 2 s",
        "expected: what users are told; times expected: prepare and evaluate beside it",
        "fill: one thread writes a constant to a fresh array of floats",
        "times fill: prepare and evaluate beside it",
        "errors: against the direct sum, term by term, at 500 random voxels and 500 near it"});
    for (const int resolution : givenOr(options.bench.resolutions, {64, 128, 256}))
    {
      addRows(table, triangles.view(), surface, resolution, threads);
    }
    tables.push_back(table);
  };
  forEachMesh(options, 0, messages, measureMesh);
  return tables;
}
