// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause

// Measures the far field: its inner loops for each order, per node, sample or dipole, on one
// thread; the tree and the moments per source, and whole evaluations per sample, on one thread and
// on two.

#include "BenchInputs.h"

#include "base/FieldOutput.h"
#include "base/FlushToZero.h"
#include "farfield/Expansions.h"
#include "farfield/FarField.h"
#include "farfield/NodeAcceptance.h"
#include "source/PointCloud.h"
#include "source/Surface.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{

using namespace winding;

/// A number between −1 and 1, without a pattern that a kernel could make use of.
float somewhere(std::size_t i)
{
  return static_cast<float>(std::sin(1.7 * static_cast<double>(i)));
}

std::vector<float> someNumbers(std::size_t count)
{
  std::vector<float> numbers(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    numbers[i] = somewhere(i);
  }
  return numbers;
}

constexpr std::size_t nodes = 1024;

/// The argument is the number of candidates.
void nodeTests(benchmark::State& state)
{
  const auto count = static_cast<std::size_t>(state.range(0));
  NodeCriteria criteria;
  criteria.resize(nodes);
  std::vector<std::int32_t> candidates(nodes);
  std::iota(candidates.begin(), candidates.end(), 0);
  for (std::size_t i = 0; i < nodes; ++i)
  {
    criteria.x[i] = somewhere(3 * i);
    criteria.y[i] = somewhere(3 * i + 1);
    criteria.z[i] = somewhere(3 * i + 2);
    criteria.radius[i] = criteria.splitRadius[i] = 0.1f + 0.09f * somewhere(i);
  }
  const CellCriteria cell = {0.5f, 0.5f, 0.5f, 0.1f, 0.1f, 1.7f, 2.3f, 0.1f};
  std::vector<std::int32_t> accepted(nodes + nodeListSlack), split = accepted, kept = accepted;
  for (auto _ : state)
  {
    NodeLists lists{accepted.data(), split.data(), kept.data()};
    classifyNodes(criteria, cell, candidates.data(), count, lists);
    benchmark::DoNotOptimize(lists);
  }
  reportTimePer(state, "time per node", count);
}

/// The arguments are the order and the number of nodes in the batch.
void translations(benchmark::State& state)
{
  const FlushToZero flush;
  const auto order = static_cast<int>(state.range(0));
  const std::vector<float> moments = someNumbers(nodes * paddedCoefficients(order));
  NodeBatch batch;
  for (std::size_t i = 0; i < NodeBatch::capacity; ++i)
  {
    batch.dx[i] = 2.5f + somewhere(3 * i);
    batch.dy[i] = 2 * somewhere(3 * i + 1);
    batch.dz[i] = 2 * somewhere(3 * i + 2);
    batch.radius[i] = 0.7f;
  }
  LocalSums sums = {};
  std::size_t next = 0;
  for (auto _ : state)
  {
    batch.count = static_cast<std::size_t>(state.range(1));
    for (std::size_t i = 0; i < batch.count; ++i)
    {
      batch.node[i] = static_cast<std::int32_t>(next++ % nodes);
    }
    translateMoments(order, moments.data(), batch, 1, sums);
    benchmark::DoNotOptimize(sums);
  }
  reportTimePer(state, "time per node", batch.count);
}

void shiftOfLocal(benchmark::State& state)
{
  const auto order = static_cast<int>(state.range(0));
  const LocalShifts shifts(order, 0.5, Eigen::Vector3d::Constant(0.25));
  const std::size_t rows = paddedCoefficients(order);
  const std::vector<float> from = someNumbers(rows);
  std::vector<float> to(rows);
  for (auto _ : state)
  {
    multiplyMatrix(shifts.matrices[5].data(), rows,
      static_cast<std::size_t>(coefficientCount(order)), from.data(), to.data());
    benchmark::DoNotOptimize(to.data());
    benchmark::ClobberMemory();
  }
  reportTimePer(state, "time per cell", 1);
}

/// Samples of a block, as offsets from a centre.
struct Offsets
{
  explicit Offsets(float distance)
  {
    for (std::size_t i = 0; i < SampleBlock::capacity; ++i)
    {
      x[i] = distance + 0.5f * somewhere(3 * i);
      y[i] = 0.5f * somewhere(3 * i + 1);
      z[i] = 0.5f * somewhere(3 * i + 2);
    }
  }
  alignas(64) float x[SampleBlock::capacity];
  alignas(64) float y[SampleBlock::capacity];
  alignas(64) float z[SampleBlock::capacity];
};

void valuesOfMoments(benchmark::State& state)
{
  const auto order = static_cast<int>(state.range(0));
  const std::vector<float> moments = someNumbers(paddedCoefficients(order));
  const Offsets at(3);
  SampleBlock samples;
  samples.count = SampleBlock::capacity;
  for (std::size_t i = 0; i < samples.count; ++i)
  {
    samples.set(i, Eigen::Vector3d(at.x[i], at.y[i], at.z[i]));
  }
  const double center[3] = {};
  alignas(64) float values[SampleBlock::capacity] = {};
  for (auto _ : state)
  {
    addMomentValues(order, moments.data(), center, 1, samples, values);
    benchmark::DoNotOptimize(values);
  }
  reportTimePer(state, "time per sample", SampleBlock::capacity);
}

void valuesOfPolynomial(benchmark::State& state)
{
  const auto order = static_cast<int>(state.range(0));
  const std::vector<float> coefficients =
    someNumbers(static_cast<std::size_t>(monomialCount(order)));
  const Offsets at(0);
  alignas(64) float values[SampleBlock::capacity];
  for (auto _ : state)
  {
    evaluatePolynomial(order, coefficients.data(), at.x, at.y, at.z, SampleBlock::capacity, values);
    benchmark::DoNotOptimize(values);
  }
  reportTimePer(state, "time per sample", SampleBlock::capacity);
}

void valuesInRow(benchmark::State& state)
{
  const auto order = static_cast<int>(state.range(0));
  const std::vector<float> coefficients = someNumbers(static_cast<std::size_t>(order) + 1);
  const Offsets at(0);
  alignas(64) float values[SampleBlock::capacity];
  for (auto _ : state)
  {
    evaluateRow(order, coefficients.data(), at.x, SampleBlock::capacity, values);
    benchmark::DoNotOptimize(values);
  }
  reportTimePer(state, "time per sample", SampleBlock::capacity);
}

void momentsOfDipoles(benchmark::State& state)
{
  const auto order = static_cast<int>(state.range(0));
  DipoleBatch batch;
  batch.count = DipoleBatch::capacity;
  for (std::size_t i = 0; i < batch.count; ++i)
  {
    batch.x[i] = 0.5f * somewhere(6 * i);
    batch.y[i] = 0.5f * somewhere(6 * i + 1);
    batch.z[i] = 0.5f * somewhere(6 * i + 2);
    batch.nx[i] = somewhere(6 * i + 3);
    batch.ny[i] = somewhere(6 * i + 4);
    batch.nz[i] = somewhere(6 * i + 5);
  }
  std::vector<float> moments(paddedCoefficients(order));
  for (auto _ : state)
  {
    addMoments(order, batch, moments.data());
    benchmark::DoNotOptimize(moments.data());
    benchmark::ClobberMemory();
  }
  reportTimePer(state, "time per dipole", batch.count);
}

std::unique_ptr<FarFieldSources> trianglesOf(int n)
{
  const Surface surface = weldedSphere(n);
  SerialExecutor serial;
  return farFieldSources(surface.vertices, surface.triangles, surface.bounds, SplitRule(), serial);
}

std::unique_ptr<FarFieldSources> pointsOf(int n)
{
  const PointCloud cloud = centroids(weldedSphere(n));
  SerialExecutor serial;
  return farFieldSources(cloud, cloud.areas, serial);
}

using MakeSources = std::unique_ptr<FarFieldSources> (*)(int n);

/// The arguments of trees and their moments are n of the sphere and the number of threads.
void tree(benchmark::State& state, MakeSources make)
{
  const auto sources = make(static_cast<int>(state.range(0)));
  Threads threads(static_cast<int>(state.range(1)));
  const std::vector<Eigen::Vector3d> centers = sources->centers(threads);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(SourceTree(centers, sources->leafSize(), threads));
  }
  reportTimePer(state, "time per source", centers.size());
}

void momentsOfTree(benchmark::State& state, MakeSources make)
{
  const auto sources = make(static_cast<int>(state.range(0)));
  Threads threads(static_cast<int>(state.range(1)));
  const SourceTree tree(sources->centers(threads), sources->leafSize(), threads);
  sources->arrange(tree.order(), false, threads);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(SourceMoments(tree, *sources, FarFieldAccuracy::of(1e-3), threads));
  }
  reportTimePer(state, "time per source", tree.order().size());
}

/// The arguments are n of the sphere, samples along each axis, digits of the tolerance, and
/// threads.
void evaluation(benchmark::State& state, MakeSources make)
{
  Threads threads(static_cast<int>(state.range(3)));
  const FarField field(make(static_cast<int>(state.range(0))),
    FarFieldAccuracy::of(std::pow(10.0, -static_cast<double>(state.range(2)))), threads);
  const Grid grid = gridAround(static_cast<int>(state.range(1)));
  std::vector<float> values(sampleCount(grid.wholeExtent()));
  FieldOutput output;
  output.values = values.data();
  for (auto _ : state)
  {
    field.evaluate(grid, grid.wholeExtent(), output, threads);
    benchmark::ClobberMemory();
  }
  reportTimePer(state, "time per sample", values.size());
}

BENCHMARK(nodeTests)->Arg(64)->Arg(nodes);
BENCHMARK(translations)->ArgsProduct({{3, 5, 7, 9}, {1, 8, 16}});
BENCHMARK(shiftOfLocal)->Arg(3)->Arg(5)->Arg(7)->Arg(9);
BENCHMARK(valuesOfMoments)->Arg(3)->Arg(5)->Arg(7)->Arg(9);
BENCHMARK(valuesOfPolynomial)->Arg(3)->Arg(5)->Arg(7)->Arg(9);
BENCHMARK(valuesInRow)->Arg(3)->Arg(5)->Arg(7)->Arg(9);
BENCHMARK(momentsOfDipoles)->Arg(3)->Arg(5)->Arg(7)->Arg(9);
BENCHMARK_CAPTURE(tree, triangles, trianglesOf)->ArgsProduct({{224, 707}, {1, 2}})->UseRealTime();
BENCHMARK_CAPTURE(tree, points, pointsOf)->ArgsProduct({{224, 707}, {1, 2}})->UseRealTime();
BENCHMARK_CAPTURE(momentsOfTree, triangles, trianglesOf)
  ->ArgsProduct({{224, 707}, {1, 2}})
  ->UseRealTime();
BENCHMARK_CAPTURE(momentsOfTree, points, pointsOf)
  ->ArgsProduct({{224, 707}, {1, 2}})
  ->UseRealTime();
BENCHMARK_CAPTURE(evaluation, triangles, trianglesOf)
  ->ArgsProduct({{224}, {64, 128, 256}, {3}, {1, 2}})
  ->ArgsProduct({{224}, {128}, {2, 4, 5, 6}, {1, 2}})
  ->UseRealTime();
BENCHMARK_CAPTURE(evaluation, points, pointsOf)
  ->ArgsProduct({{224}, {64, 128, 256}, {3}, {1, 2}})
  ->ArgsProduct({{224}, {128}, {2, 4, 5, 6}, {1, 2}})
  ->UseRealTime();

} // namespace
