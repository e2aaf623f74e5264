// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "laboratory/BenchGrid.h"

#include <random>

winding::Grid benchGrid(const winding::Bounds& bounds, int resolution)
{
  winding::GridRequest request;
  request.bounds = bounds;
  request.padding = 0.05;
  request.resolution = resolution;
  return winding::setUpGrid(request);
}

std::string sizeOf(const winding::Grid& grid)
{
  return std::to_string(grid.dimensions[0]) + " x " + std::to_string(grid.dimensions[1]) + " x " +
         std::to_string(grid.dimensions[2]);
}

std::vector<double> randomSamples(const winding::Grid& grid, std::size_t count)
{
  std::mt19937_64 random(20260101);
  std::vector<double> samples;
  samples.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i)
  {
    Eigen::Vector3i index;
    for (int axis = 0; axis < 3; ++axis)
    {
      index[axis] = std::uniform_int_distribution<int>(0, grid.dimensions[axis] - 1)(random);
    }
    const Eigen::Vector3d sample = grid.sample(index[0], index[1], index[2]);
    samples.insert(samples.end(), sample.data(), sample.data() + 3);
  }
  return samples;
}
