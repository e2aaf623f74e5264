// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "laboratory/BenchGrid.h"
#include "laboratory/BenchOptions.h"
#include "laboratory/BenchSubjects.h"
#include "laboratory/FarFieldCosts.h"
#include "laboratory/NaiveSums.h"
#include "laboratory/Shapes.h"
#include "laboratory/ThreadExecutor.h"
#include "laboratory/Timing.h"
#include "program/Interrupt.h"
#include "program/Threads.h"

#include "base/Executor.h"
#include "base/FieldOutput.h"
#include "base/Views.h"
#include "farfield/MultipoleKernels.h"
#include "farfield/SourceMoments.h"
#include "rays/RayParity.h"
#include "rays/RowCrossings.h"
#include "source/PointCloud.h"
#include "source/Sanitize.h"
#include "source/Surface.h"
#include "sums/DirectSum.h"
#include "sums/DirectSumKernels.h"
#include "sums/ReferenceSum.h"
#include "surface/Cap.h"

#include <atomic>
#include <cmath>

namespace
{

/// Nanoseconds per item of work() on `items` items, the least of some runs.
template <class Work> double nanoseconds(const Work& work, std::size_t items, int runs = 20)
{
  const double seconds = secondsOf(work, runs);
  interrupt::check();
  return 1e9 * seconds / static_cast<double>(items);
}

Json line(const std::string& what, double value, const char* unit, std::size_t threads = 1)
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
  const char* const unit = "ns per primitive and sample";
  const winding::SampleBlock block = someSamples(grid);
  double values[winding::SampleBlock::capacity];
  const auto add = [&](const char* what, const winding::Evaluator& sum, std::size_t primitives)
  {
    const auto evaluate = [&]
    {
      sum.evaluate(block, values);
    };
    table.add(line(what, nanoseconds(evaluate, primitives * block.count), unit));
  };
  add("direct sum, triangles", winding::TriangleSum(surface), surface.triangles.size());
  const winding::PointCloud cloud = verticesOf(surface);
  const std::vector<double> areas(cloud.positions.size(), 1e-4);
  add("direct sum, points", winding::DipoleSum(cloud, areas), cloud.positions.size());
  add("parity", winding::RayParity(surface), surface.triangles.size());
  volatile double used = 0;
  const auto sumTerms = [&]
  {
    used = winding::referenceSum<double>(surface, {block.x[0], block.y[0], block.z[0]});
  };
  table.add(line("term by term, triangles", nanoseconds(sumTerms, surface.triangles.size()), unit));
}

void addPreparation(BenchTable& table, const winding::TrianglesView& view,
  const winding::Surface& surface, winding::Executor& executor, std::size_t threads)
{
  const std::size_t triangles = surface.triangles.size();
  const auto weld = [&]
  {
    winding::sanitize({view}, executor);
  };
  table.add(line("welding", nanoseconds(weld, triangles), "ns per triangle", threads));
  const auto findBoundary = [&]
  {
    winding::boundaryChain(surface, executor);
  };
  table.add(line(
    "boundary, closed surface", nanoseconds(findBoundary, triangles), "ns per triangle", threads));
}

/// Adds the work that a surface with holes needs beyond that of a closed one.
void addCap(BenchTable& table, const winding::Surface& closed, const winding::Grid& grid)
{
  const winding::Surface surface = withHoles(closed, 50);
  winding::SerialExecutor executor;
  const winding::BoundaryChain chain = winding::boundaryChain(surface, executor);
  const auto makeCap = [&]
  {
    return winding::capOf(winding::boundaryLoops(chain.edges, surface.vertices.size(), executor));
  };
  table.add(
    line("loops and cap", nanoseconds(makeCap, chain.edges.size()), "ns per boundary edge"));
  const winding::TriangleList cap = makeCap();
  const winding::TriangleSum sum(surface.vertices, cap, surface.bounds);
  const winding::SampleBlock block = someSamples(grid);
  double values[winding::SampleBlock::capacity];
  bool isSuspect[winding::SampleBlock::capacity];
  const auto evaluate = [&]
  {
    sum.evaluateWatching(block, values, isSuspect);
  };
  table.add(
    line("cap sum", nanoseconds(evaluate, cap.size() * block.count), "ns per triangle and sample"));
}

void addCrossings(BenchTable& table, const winding::Surface& surface, const winding::Grid& grid,
  winding::Executor& executor, std::size_t threads)
{
  const winding::RowCrossings rows(surface.vertices, surface.triangles);
  const auto findRuns = [&](const auto& take)
  {
    rows.evaluate(grid, grid.wholeExtent(), 65536, take, executor);
  };
  // Each run of a row but the first begins at a crossing. Two crossings between the same samples
  // are not seen here; on a grid as fine as this they are few.
  std::atomic<std::size_t> crossings = 0;
  findRuns(
    [&](int, int, const std::vector<winding::RowRun>& runs) { crossings += runs.size() - 1; });
  const auto takeNothing = [](int, int, const std::vector<winding::RowRun>&) {
  };
  const double perCrossing = nanoseconds([&] { findRuns(takeNothing); }, crossings);
  table.add(line("crossings", 1e3 / perCrossing, "million per second", threads));
}

/// Adds the parts of an evaluation by far fields, each measured alone.
void addExpansions(BenchTable& table)
{
  const auto add = [&table](const std::string& what, double seconds, const char* unit)
  {
    table.add(line(what, 1e9 * seconds, unit));
  };
  for (const int order : {3, 5, 7, 9})
  {
    const FarFieldCosts costs = measureFarFieldCosts(order);
    const std::string suffix = ", order " + std::to_string(order);
    if (order == 3)
    {
      add("node tests", costs.nodeTest, "ns per node and cell");
    }
    constexpr auto full = static_cast<double>(winding::NodeBatch::capacity);
    add("translations, full batch" + suffix, (costs.firstNode + (full - 1) * costs.nextNode) / full,
      "ns per node and cell");
    add("translations, one alone" + suffix, costs.firstNode, "ns per node and cell");
    add("sums of translations" + suffix, costs.receiver, "ns per cell");
    add("shifts of expansions" + suffix, costs.shift, "ns per cell");
    add("polynomials from expansions" + suffix, costs.polynomial, "ns per cell");
    add("values of polynomials" + suffix, costs.polynomialValue, "ns per sample");
    add("cells of 8 x 8 x 8" + suffix, costs.blockSample, "ns per sample");
    add("rows of 64" + suffix, costs.rowSample + costs.row / 64, "ns per sample");
    add("values of moments" + suffix, costs.momentValue, "ns per node and sample");
    add("moments of dipoles" + suffix, costs.dipole, "ns per dipole");
  }
}

void addTree(BenchTable& table, const std::string& of, winding::FarFieldSources& sources,
  winding::Executor& executor, std::size_t threads)
{
  const char* const unit = "ns per source";
  const std::vector<Eigen::Vector3d> centers = sources.centers(executor);
  const auto makeTree = [&]
  {
    return winding::SourceTree(centers, sources.leafSize(), executor);
  };
  table.add(line("source tree, " + of, nanoseconds(makeTree, centers.size(), 5), unit, threads));
  const winding::SourceTree tree = makeTree();
  sources.arrange(tree.order(), false, executor);
  const winding::FarFieldAccuracy accuracy = winding::FarFieldAccuracy::of(1e-3);
  const auto makeMoments = [&]
  {
    return winding::SourceMoments(tree, sources, accuracy, executor);
  };
  table.add(line("moments of all nodes, " + of + ", order " + std::to_string(accuracy.order),
    nanoseconds(makeMoments, centers.size(), 5), unit, threads));
}

void addTrees(BenchTable& table, const winding::Surface& surface, winding::Executor& executor,
  std::size_t threads)
{
  // The sources are made anew for each executor, since addTree() puts them into the tree's order.
  const auto triangles = winding::farFieldSources(
    surface.vertices, surface.triangles, surface.bounds, winding::SplitRule(), executor);
  addTree(table, "triangles", *triangles, executor, threads);
  const winding::PointCloud cloud = verticesOf(surface);
  const auto points = winding::farFieldSources(cloud, cloud.areas, executor);
  addTree(table, "points", *points, executor, threads);
}

void addFill(BenchTable& table, const winding::Grid& grid)
{
  const std::size_t samples = winding::sampleCount(grid.wholeExtent());
  const double bytes = 4e-9 * static_cast<double>(samples);
  table.add(line("fill, fresh memory", bytes / secondsToFill(samples), "GB/s"));
  std::vector<float> values(samples);
  winding::FieldOutput output;
  output.values = values.data();
  const auto fill = [&]
  {
    output.fill(1, 0, samples);
  };
  table.add(line("fill, used memory", bytes / secondsOf(fill), "GB/s"));
}

} // namespace

std::vector<BenchTable> benchKernels(const BenchOptions& options, Messages&)
{
  const Triangles sphere = lumpySphere(224);
  const winding::TrianglesView view = sphere.view();
  winding::SerialExecutor serial;
  const winding::Surface surface = winding::sanitize({view}, serial);
  const winding::Grid grid = benchGrid(surface.bounds, 256);

  BenchTable table("Parts of the methods, on a lumpy sphere of " +
                     std::to_string(surface.triangles.size()) + " triangles and a grid of 256",
    {std::string("instructions: ") + winding::kernelInstructionSet()});
  addSums(table, surface, grid);
  ThreadExecutor threads;
  const auto threadCount = static_cast<std::size_t>(threadsUsed(options.threads));
  addPreparation(table, view, surface, serial, 1);
  addPreparation(table, view, surface, threads, threadCount);
  addCap(table, surface, grid);
  addCrossings(table, surface, grid, serial, 1);
  addCrossings(table, surface, grid, threads, threadCount);
  addExpansions(table);
  addTrees(table, surface, serial, 1);
  addTrees(table, surface, threads, threadCount);
  addFill(table, grid);
  return {table};
}
