// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause

// Measures the parts of method rows: welding and boundary per triangle, on one thread and on two;
// and on one thread the cap per boundary edge, crossings and bytes per second on a grid, and the
// sum over the cap per triangle and sample.

#include "BenchInputs.h"

#include "base/FieldOutput.h"
#include "base/Views.h"
#include "rays/RowCrossings.h"
#include "source/Sanitize.h"
#include "source/Surface.h"
#include "sums/DirectSum.h"
#include "surface/Cap.h"

#include <benchmark/benchmark.h>

#include <memory>

namespace
{

using namespace winding;

/// The arguments of welding and boundary are n of the sphere and the number of threads.
void weldingOfSoup(benchmark::State& state)
{
  const Triangles soup = lumpySphere(static_cast<int>(state.range(0)));
  Threads threads(static_cast<int>(state.range(1)));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(sanitize(std::vector{soup.view()}, threads));
  }
  reportTimePer(state, "time per triangle", soup.triangles());
}

void weldingOfMesh(benchmark::State& state)
{
  const Surface surface = weldedSphere(static_cast<int>(state.range(0)));
  const TrianglesView view = {{surface.vertices[0].data(), surface.vertices.size()},
    {surface.triangles[0].data(), surface.triangles.size()}};
  Threads threads(static_cast<int>(state.range(1)));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(sanitize(std::vector<TrianglesView>{view}, threads));
  }
  reportTimePer(state, "time per triangle", surface.triangles.size());
}

void boundaryOf(benchmark::State& state, const Surface& surface)
{
  Threads threads(static_cast<int>(state.range(1)));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(boundaryChain(surface, threads));
  }
  reportTimePer(state, "time per triangle", surface.triangles.size());
}

void boundaryOfClosed(benchmark::State& state)
{
  boundaryOf(state, weldedSphere(static_cast<int>(state.range(0))));
}

void boundaryOfOpen(benchmark::State& state)
{
  boundaryOf(state, withHoles(weldedSphere(static_cast<int>(state.range(0))), 10));
}

void loopsAndCap(benchmark::State& state)
{
  const Surface surface = withHoles(weldedSphere(static_cast<int>(state.range(0))), 10);
  SerialExecutor serial;
  const BoundaryChain chain = boundaryChain(surface, serial);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(capOf(boundaryLoops(chain.edges, surface.vertices.size(), serial)));
  }
  reportTimePer(state, "time per boundary edge", chain.edges.size());
}

/// The arguments are n of the sphere and samples along each axis.
void crossings(benchmark::State& state)
{
  const Surface surface = weldedSphere(static_cast<int>(state.range(0)));
  const Grid grid = gridAround(static_cast<int>(state.range(1)));
  const RowCrossings rows(surface.vertices, surface.triangles);
  SerialExecutor executor;
  std::size_t count = 0;
  for (auto _ : state)
  {
    count = 0;
    rows.evaluate(
      grid, grid.wholeExtent(), 65536,
      [&count](int, int, const std::vector<RowRun>& runs) { count += runs.size() - 1; }, executor);
  }
  // Two crossings between the same samples are not seen here; on a fine grid they are few.
  state.counters["crossings"] = static_cast<double>(count);
  reportTimePer(state, "time per crossing", count);
}

/// The array is fresh each time: its pages are touched first by the fill, as in a new image.
void fillFresh(benchmark::State& state)
{
  const auto samples = static_cast<std::size_t>(state.range(0));
  for (auto _ : state)
  {
    const std::unique_ptr<float[]> values(new float[samples]);
    FieldOutput output;
    output.values = values.get();
    output.fill(1, 0, samples);
    benchmark::DoNotOptimize(values.get());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(
    static_cast<std::int64_t>(4 * samples) * static_cast<std::int64_t>(state.iterations()));
}

void fillUsed(benchmark::State& state)
{
  const auto samples = static_cast<std::size_t>(state.range(0));
  std::vector<float> values(samples);
  FieldOutput output;
  output.values = values.data();
  for (auto _ : state)
  {
    output.fill(1, 0, samples);
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(
    static_cast<std::int64_t>(4 * samples) * static_cast<std::int64_t>(state.iterations()));
}

/// The sum that open surfaces need, watching for samples on the cap.
void capSum(benchmark::State& state)
{
  const Surface surface = withHoles(weldedSphere(static_cast<int>(state.range(0))), 10);
  SerialExecutor serial;
  const TriangleList cap =
    capOf(boundaryLoops(boundaryChain(surface, serial).edges, surface.vertices.size(), serial));
  const TriangleSum sum(surface.vertices, cap, surface.bounds);
  const SampleBlock block = someSamples();
  double values[SampleBlock::capacity];
  bool isSuspect[SampleBlock::capacity];
  for (auto _ : state)
  {
    sum.evaluateWatching(block, values, isSuspect);
    benchmark::DoNotOptimize(values);
  }
  reportTimePer(state, "time per pair", cap.size() * block.count);
}

constexpr int megabyteOfFloats = 1 << 18;

BENCHMARK(weldingOfSoup)->ArgsProduct({{20, 224, 707}, {1, 2}})->UseRealTime();
BENCHMARK(weldingOfMesh)->ArgsProduct({{20, 224, 707}, {1, 2}})->UseRealTime();
BENCHMARK(boundaryOfClosed)->ArgsProduct({{20, 224, 707}, {1, 2}})->UseRealTime();
BENCHMARK(boundaryOfOpen)->ArgsProduct({{20, 224, 707}, {1, 2}})->UseRealTime();
BENCHMARK(loopsAndCap)->Arg(224);
BENCHMARK(crossings)->Args({20, 256})->Args({224, 128})->Args({224, 256});
BENCHMARK(fillFresh)->Arg(64 * megabyteOfFloats);
BENCHMARK(fillUsed)->Arg(megabyteOfFloats)->Arg(64 * megabyteOfFloats);
BENCHMARK(capSum)->Arg(20)->Arg(224);

} // namespace
