// Time per primitive and sample of the methods that sum over everything, on one thread, on the
// triangles (and their centroids, as points) of a lumpy closed surface.

#include "DirectSum.h"
#include "DirectSumKernels.h"
#include "RayParity.h"
#include "ReferenceSum.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace
{

using namespace winding;

/// A sphere of 2·n·n triangles whose radius varies.
Surface lumpySphere(int n)
{
  std::vector<double> points;
  std::vector<std::int32_t> ids;
  const double pi = std::acos(-1.0);
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const double theta = pi * i / n, phi = 2 * pi * j / n;
      const double r = 1 + 0.2 * std::sin(5 * theta) * std::cos(4 * phi);
      points.insert(points.end(), {r * std::sin(theta) * std::cos(phi),
                                    r * std::sin(theta) * std::sin(phi), r * std::cos(theta)});
    }
  }
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const int a = i * n + j, b = i * n + (j + 1) % n;
      ids.insert(ids.end(), {a, a + n, b, b, a + n, b + n});
    }
  }
  TrianglesView view{{points.data(), points.size() / 3}, {ids.data(), ids.size() / 3}};
  return sanitize(std::vector<TrianglesView>{view});
}

PointCloud centroids(const Surface& surface)
{
  PointCloud cloud;
  for (const Triangle& t : surface.triangles)
  {
    const Eigen::Vector3d &a = surface.vertices[t[0]], &b = surface.vertices[t[1]],
                          &c = surface.vertices[t[2]];
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    cloud.positions.push_back((a + b + c) / 3);
    cloud.normals.push_back(normal.normalized());
    cloud.areas.push_back(normal.norm() / 2);
    cloud.bounds.extend(cloud.positions.back());
  }
  return cloud;
}

SampleBlock someSamples()
{
  SampleBlock block;
  block.count = SampleBlock::capacity;
  for (std::size_t i = 0; i < block.count; ++i)
  {
    block.x[i] = std::sin(1.7 * static_cast<double>(i));
    block.y[i] = std::sin(2.3 * static_cast<double>(i) + 1);
    block.z[i] = std::sin(3.1 * static_cast<double>(i) + 2);
  }
  return block;
}

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
  const Surface surface = lumpySphere(static_cast<int>(state.range(0)));
  runEvaluator(state, TriangleSum(surface), surface.triangles.size());
}

void directPoints(benchmark::State& state)
{
  const PointCloud cloud = centroids(lumpySphere(static_cast<int>(state.range(0))));
  runEvaluator(state, DipoleSum(cloud, cloud.areas), cloud.positions.size());
}

void parity(benchmark::State& state)
{
  const Surface surface = lumpySphere(static_cast<int>(state.range(0)));
  runEvaluator(state, RayParity(surface), surface.triangles.size());
}

void reference(benchmark::State& state)
{
  const Surface surface = lumpySphere(static_cast<int>(state.range(0)));
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
BENCHMARK(parity)->Arg(20)->Arg(200);
BENCHMARK(reference)->Arg(20)->Arg(200);

} // namespace
