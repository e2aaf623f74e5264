// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "laboratory/Shapes.h"

#include "base/Evaluator.h"
#include "base/Executor.h"
#include "source/Grid.h"
#include "source/PointCloud.h"
#include "source/Surface.h"

#include <benchmark/benchmark.h>

/**
 * @file
 * Threads, inputs and reports of the benchmarks; their shapes are in laboratory/Shapes.h.
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

/// The sphere of Shapes.h, with common points.
winding::Surface weldedSphere(int n);

/// The centres of the triangles, with their normals and areas; none for triangles without area.
winding::PointCloud centroids(const winding::Surface& surface);

/// A full block of samples in and around the sphere.
winding::SampleBlock someSamples();

/// n³ samples over the sphere and a margin.
winding::Grid gridAround(int n);

/// Reports the time of one of the `count` things that each iteration does.
void reportTimePer(benchmark::State& state, const char* what, std::size_t count);
