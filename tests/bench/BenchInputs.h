// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Evaluator.h"
#include "base/Executor.h"
#include "base/Views.h"
#include "source/Grid.h"
#include "source/PointCloud.h"
#include "source/Surface.h"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <vector>

/**
 * @file
 * Threads, inputs and reports of the benchmarks.
 */

/// Runs blocks on a number of threads.
class Threads final : public winding::Executor
{
public:
  explicit Threads(int threads)
    : threads_(threads)
  {
  }
  void run(std::size_t count, const std::function<void(std::size_t)>& work) override;

private:
  int threads_;
};

/// Coordinates and triangles of a mesh in double precision, as the core's views take them.
struct Triangles
{
  std::vector<double> coordinates; ///< x y z of each point
  std::vector<std::int64_t> ids;   ///< three points of each triangle

  std::size_t points() const { return coordinates.size() / 3; }
  std::size_t triangles() const { return ids.size() / 3; }

  /// Returns a view of these arrays, which must not change while it is used.
  winding::TrianglesView view() const
  {
    return {{coordinates.data(), this->points()}, {ids.data(), this->triangles()}};
  }
};

/// Makes a closed sphere of 2 n² triangles whose radius varies, without common points, as in a
/// .stl file. `n` is at least 3.
Triangles lumpySphere(int n);

/// Makes the same sphere with common points.
winding::Surface weldedSphere(int n);

/// Returns `surface` without every `period`-th triangle, from the first one on; each leaves a hole.
winding::Surface withHoles(const winding::Surface& surface, std::size_t period);

/// The centres of the triangles, with their normals and areas; none for triangles without area.
winding::PointCloud centroids(const winding::Surface& surface);

/// A full block of samples in and around the sphere.
winding::SampleBlock someSamples();

/// n³ samples over the sphere and a margin.
winding::Grid gridAround(int n);

/// Reports the time of one of the `count` things that each iteration does.
void reportTimePer(benchmark::State& state, const char* what, std::size_t count);
