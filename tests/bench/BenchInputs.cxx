// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchInputs.h"

#include "source/Sanitize.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <thread>
#include <utility>

using namespace winding;

void Threads::run(std::size_t count, const std::function<void(std::size_t)>& work)
{
  std::atomic<std::size_t> next = 0;
  const auto takeBlocks = [&]
  {
    for (std::size_t block = next++; block < count; block = next++)
    {
      work(block);
    }
  };
  std::vector<std::thread> others;
  for (std::size_t i = 1; i < std::min<std::size_t>(count, static_cast<std::size_t>(threads_)); ++i)
  {
    others.emplace_back(takeBlocks);
  }
  takeBlocks();
  for (std::thread& thread : others)
  {
    thread.join();
  }
}

Triangles lumpySphere(int n)
{
  const double pi = std::acos(-1.0);
  const auto point = [&](int i, int j) -> Eigen::Vector3d
  {
    const double theta = pi * i / n, phi = 2 * pi * (j % n) / n;
    const double r = 1 + 0.2 * std::sin(5 * theta) * std::cos(4 * phi);
    return {r * std::sin(theta) * std::cos(phi), r * std::sin(theta) * std::sin(phi),
      r * std::cos(theta)};
  };
  Triangles sphere;
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      for (const auto& [di, dj] : {std::pair(0, 0), {1, 0}, {0, 1}, {0, 1}, {1, 0}, {1, 1}})
      {
        const Eigen::Vector3d corner = point(i + di, j + dj);
        sphere.coordinates.insert(sphere.coordinates.end(), corner.data(), corner.data() + 3);
      }
    }
  }
  sphere.ids.resize(sphere.points());
  std::iota(sphere.ids.begin(), sphere.ids.end(), 0);
  return sphere;
}

Surface weldedSphere(int n)
{
  const Triangles sphere = lumpySphere(n);
  SerialExecutor serial;
  return sanitize(std::vector{sphere.view()}, serial);
}

Surface withHoles(const Surface& surface, std::size_t period)
{
  Surface result = surface;
  result.triangles.clear();
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    if (i % period != 0)
    {
      result.triangles.push_back(surface.triangles[i]);
    }
  }
  return result;
}

PointCloud centroids(const Surface& surface)
{
  PointCloud cloud;
  for (const Triangle& t : surface.triangles)
  {
    const Eigen::Vector3d& a = surface.vertices[t[0]];
    const Eigen::Vector3d& b = surface.vertices[t[1]];
    const Eigen::Vector3d& c = surface.vertices[t[2]];
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    if (normal.isZero(0))
    {
      continue; // the poles have triangles without area
    }
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

Grid gridAround(int n)
{
  Grid grid;
  grid.dimensions = Eigen::Vector3i::Constant(n);
  grid.spacing = Eigen::Vector3d::Constant(2.8 / n);
  grid.firstSample = Eigen::Vector3d::Constant(-1.4) + 0.5 * grid.spacing;
  return grid;
}

void reportTimePer(benchmark::State& state, const char* what, std::size_t count)
{
  const double all = static_cast<double>(count) * static_cast<double>(state.iterations());
  state.counters[what] =
    benchmark::Counter(all, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
