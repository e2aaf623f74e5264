#include "BenchCommands.h"
#include "BenchTools.h"
#include "Interrupt.h"
#include "NaiveSums.h"

#include "Cap.h"
#include "DirectSum.h"
#include "DirectSumKernels.h"
#include "RayParity.h"
#include "ReferenceSum.h"
#include "RowCrossings.h"

#include <atomic>
#include <cmath>

namespace
{

/// A lumpy sphere of 2 n² triangles, without common points, as in a .stl file.
std::vector<double> lumpySphere(int n)
{
  const double pi = std::acos(-1.0);
  const auto point = [&](int i, int j) -> Eigen::Vector3d
  {
    const double theta = pi * i / n, phi = 2 * pi * (j % n) / n;
    const double r = 1 + 0.2 * std::sin(5 * theta) * std::cos(4 * phi);
    return {r * std::sin(theta) * std::cos(phi), r * std::sin(theta) * std::sin(phi),
      r * std::cos(theta)};
  };
  std::vector<double> corners;
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      for (const auto& [di, dj] : {std::pair(0, 0), {1, 0}, {0, 1}, {0, 1}, {1, 0}, {1, 1}})
      {
        const Eigen::Vector3d corner = point(i + di, j + dj);
        corners.insert(corners.end(), corner.data(), corner.data() + 3);
      }
    }
  }
  return corners;
}

/// Per item, the least of some runs.
template <class Work> double nanoseconds(const Work& work, std::size_t items)
{
  const double seconds = secondsOf(work, 20);
  interrupt::check();
  return 1e9 * seconds / static_cast<double>(items);
}

Json line(const char* what, double value, const char* unit, std::size_t threads = 1)
{
  return {{"what", what}, {"value", value}, {"unit", unit}, {"threads", threads}};
}

winding::SampleBlock someSamples(const winding::Grid& grid)
{
  winding::SampleBlock block;
  block.count = winding::SampleBlock::capacity;
  const std::vector<double> samples = randomSamples(grid, block.count);
  for (std::size_t i = 0; i < block.count; ++i)
  {
    block.x[i] = samples[3 * i];
    block.y[i] = samples[3 * i + 1];
    block.z[i] = samples[3 * i + 2];
  }
  return block;
}

void addSums(BenchTable& table, const winding::Surface& surface, const winding::Grid& grid)
{
  const winding::SampleBlock block = someSamples(grid);
  double values[winding::SampleBlock::capacity];
  const auto add = [&](
                     const char* what, const winding::Evaluator& evaluator, std::size_t primitives)
  {
    table.add(
      line(what, nanoseconds([&] { evaluator.evaluate(block, values); }, primitives * block.count),
        "ns per primitive and sample"));
  };
  add("direct sum, triangles", winding::TriangleSum(surface), surface.triangles.size());
  const winding::PointCloud cloud = verticesOf(surface);
  const std::vector<double> areas(cloud.positions.size(), 1e-4);
  add("direct sum, points", winding::DipoleSum(cloud, areas), cloud.positions.size());
  add("parity", winding::RayParity(surface), surface.triangles.size());
  volatile double used = 0;
  table.add(line("term by term, triangles",
    nanoseconds(
      [&] {
        used = winding::referenceSum<double>(surface, {block.x[0], block.y[0], block.z[0]});
      },
      surface.triangles.size()),
    "ns per primitive and sample"));
}

void addPreparation(BenchTable& table, const winding::TrianglesView& view,
  const winding::Surface& surface, winding::Executor& executor, std::size_t threads)
{
  const std::size_t triangles = surface.triangles.size();
  table.add(line("welding", nanoseconds([&] { winding::sanitize({view}, executor); }, triangles),
    "ns per triangle", threads));
  table.add(line("boundary, closed surface",
    nanoseconds([&] { winding::boundaryChain(surface, executor); }, triangles), "ns per triangle",
    threads));
}

/// What a surface with holes takes in addition: here every 50th triangle is missing.
void addCap(BenchTable& table, const winding::Surface& closed, const winding::Grid& grid)
{
  winding::Surface surface = closed;
  surface.triangles.clear();
  for (std::size_t i = 0; i < closed.triangles.size(); ++i)
  {
    if (i % 50 != 0)
    {
      surface.triangles.push_back(closed.triangles[i]);
    }
  }
  winding::SerialExecutor executor;
  const winding::BoundaryChain chain = winding::boundaryChain(surface, executor);
  const auto makeCap = [&]
  {
    return winding::capOf(winding::boundaryLoops(chain, surface.vertices.size()));
  };
  table.add(
    line("loops and cap", nanoseconds(makeCap, chain.edges.size()), "ns per boundary edge"));
  const std::vector<winding::Triangle> cap = makeCap();
  const winding::TriangleSum sum(surface.vertices, cap, surface.bounds);
  const winding::SampleBlock block = someSamples(grid);
  double values[winding::SampleBlock::capacity];
  bool isSuspect[winding::SampleBlock::capacity];
  table.add(line("cap sum",
    nanoseconds([&] { sum.evaluateWatching(block, values, isSuspect); }, cap.size() * block.count),
    "ns per triangle and sample"));
}

void addCrossings(BenchTable& table, const winding::Surface& surface, const winding::Grid& grid,
  winding::Executor& executor, std::size_t threads)
{
  const winding::RowCrossings rows(surface.vertices, surface.triangles);
  // Each run but the first of a row begins at a crossing: near enough, on a grid as fine as this.
  std::atomic<std::size_t> crossings = 0;
  const auto count = [&](int, int, const std::vector<winding::RowRun>& runs)
  {
    crossings += runs.size() - 1;
  };
  rows.evaluate(grid, grid.wholeExtent(), 65536, count, executor);
  const double perCrossing = nanoseconds(
    [&]
    {
      rows.evaluate(
        grid, grid.wholeExtent(), 65536, [](int, int, const std::vector<winding::RowRun>&) {},
        executor);
    },
    crossings);
  table.add(line("crossings", 1e3 / perCrossing, "million per second", threads));
}

void addFill(BenchTable& table, const winding::Grid& grid)
{
  const std::size_t samples = winding::sampleCount(grid.wholeExtent());
  const double bytes = 4e-9 * static_cast<double>(samples);
  table.add(line("fill, fresh memory", bytes / secondsToFill(samples), "GB/s"));
  std::vector<float> values(samples);
  winding::FieldOutput output;
  output.values = values.data();
  table.add(
    line("fill, used memory", bytes / secondsOf([&] { output.fill(1, 0, samples); }), "GB/s"));
}

} // namespace

std::vector<BenchTable> benchKernels(const Options& options)
{
  const std::vector<double> corners = lumpySphere(224);
  std::vector<std::int32_t> ids(corners.size() / 3);
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    ids[i] = static_cast<std::int32_t>(i);
  }
  const winding::TrianglesView view = {
    {corners.data(), corners.size() / 3}, {ids.data(), ids.size() / 3}};
  winding::SerialExecutor serial;
  const winding::Surface surface = winding::sanitize({view}, serial);
  winding::GridRequest request;
  request.bounds = surface.bounds;
  request.padding = 0.05;
  request.resolution = 256;
  const winding::Grid grid = winding::layOutGrid(request);

  BenchTable table("Parts of the methods, on a lumpy sphere of " +
                     std::to_string(surface.triangles.size()) + " triangles and a grid of 256",
    {std::string("instructions: ") + winding::kernelInstructionSet()});
  addSums(table, surface, grid);
  ThreadExecutor threads;
  const auto threadCount = static_cast<std::size_t>(threadsOf(options));
  addPreparation(table, view, surface, serial, 1);
  addPreparation(table, view, surface, threads, threadCount);
  addCap(table, surface, grid);
  addCrossings(table, surface, grid, serial, 1);
  addCrossings(table, surface, grid, threads, threadCount);
  addFill(table, grid);
  return {table};
}
