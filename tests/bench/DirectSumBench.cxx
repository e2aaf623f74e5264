// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause

// Measures the time per primitive and sample of the methods that sum over all primitives, on one
// thread, for the triangles of a lumpy closed surface and for their centroids as points.

#include "BenchInputs.h"

#include "rays/RayParity.h"
#include "source/PointCloud.h"
#include "source/Surface.h"
#include "sums/DirectSum.h"
#include "sums/DirectSumKernels.h"
#include "sums/ReferenceSum.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace
{

using namespace winding;

/// Reports the time of one primitive at one sample, and the instructions that the kernels use.
void report(benchmark::State& state, std::size_t primitives, std::size_t samples)
{
  const double pairs =
    static_cast<double>(primitives) * static_cast<double>(samples) * state.iterations();
  state.counters["time per pair"] =
    benchmark::Counter(pairs, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.SetLabel(kernelInstructionSet());
}

void runEvaluator(benchmark::State& state, const Evaluator& evaluator, std::size_t primitives)
{
  const SampleBlock block = someSamples();
  double values[SampleBlock::capacity];
  for (auto _ : state)
  {
    evaluator.evaluate(block, values);
    benchmark::DoNotOptimize(values);
  }
  report(state, primitives, block.count);
}

void directTriangles(benchmark::State& state)
{
  const Surface surface = weldedSphere(static_cast<int>(state.range(0)));
  runEvaluator(state, TriangleSum(surface), surface.triangles.size());
}

void directPoints(benchmark::State& state)
{
  const PointCloud cloud = centroids(weldedSphere(static_cast<int>(state.range(0))));
  runEvaluator(state, DipoleSum(cloud, cloud.areas), cloud.positions.size());
}

void directRegularizedPoints(benchmark::State& state)
{
  PointCloud cloud = centroids(weldedSphere(static_cast<int>(state.range(0))));
  for (const double area : cloud.areas)
  {
    cloud.regularizationLengths.push_back(std::sqrt(area));
  }
  runEvaluator(state, DipoleSum(cloud, cloud.areas), cloud.positions.size());
}

void parity(benchmark::State& state)
{
  const Surface surface = weldedSphere(static_cast<int>(state.range(0)));
  runEvaluator(state, RayParity(surface), surface.triangles.size());
}

void reference(benchmark::State& state)
{
  const Surface surface = weldedSphere(static_cast<int>(state.range(0)));
  const SampleBlock block = someSamples();
  double sum = 0;
  for (auto _ : state)
  {
    sum += referenceSum<double>(surface, {block.x[0], block.y[0], block.z[0]});
  }
  benchmark::DoNotOptimize(sum);
  report(state, surface.triangles.size(), 1);
}

BENCHMARK(directTriangles)->Arg(20)->Arg(200);
BENCHMARK(directPoints)->Arg(20)->Arg(200);
BENCHMARK(directRegularizedPoints)->Arg(20)->Arg(200);
BENCHMARK(parity)->Arg(20)->Arg(200);
BENCHMARK(reference)->Arg(20)->Arg(200);

} // namespace
