// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "source/Grid.h"

#include <vector>

namespace shapes
{

/// Sets up a grid of cubic voxels around bounds; `padding` is in longest sides.
inline winding::Grid gridAround(const winding::Bounds& bounds, int resolution, double padding = 0)
{
  winding::GridRequest request;
  request.bounds = bounds;
  request.resolution = resolution;
  request.padding = padding;
  return winding::setUpGrid(request);
}

/// Sets up a grid of given dimensions around bounds.
inline winding::Grid gridAround(
  const winding::Bounds& bounds, const Eigen::Vector3i& dimensions, double padding = 0)
{
  winding::GridRequest request;
  request.bounds = bounds;
  request.dimensions = dimensions;
  request.padding = padding;
  return winding::setUpGrid(request);
}

inline std::vector<Eigen::Vector3d> samplesOf(const winding::Grid& grid)
{
  std::vector<Eigen::Vector3d> samples(winding::sampleCount(grid.wholeExtent()));
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    samples[n] = grid.sample(n);
  }
  return samples;
}

} // namespace shapes
