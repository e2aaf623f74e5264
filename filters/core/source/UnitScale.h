// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "base/Evaluator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

/**
 * @file
 * Coordinates are scaled to about unit size before kernels multiply them: products of three lengths
 * would leave the range of double for sources of size 1e±110 and beyond. The factor is a power of
 * two, so the scaling itself rounds nothing.
 */
namespace winding
{

/// 2^k such that the longest side of the bounds becomes 1 … 2. Bounds without extent get 1, or what
/// makes their largest coordinate 1 … 2 if it is larger, so that samples are cut off beyond it.
inline double unitScale(const Bounds& bounds)
{
  double longest = bounds.isEmpty() ? 0 : bounds.sizes().maxCoeff();
  if (longest == 0 && !bounds.isEmpty() && bounds.min().cwiseAbs().maxCoeff() > 1)
  {
    longest = bounds.min().cwiseAbs().maxCoeff();
  }
  // The largest exponents are left out: 2^k itself must stay a finite, normal number.
  return longest > 0 ? std::ldexp(1.0, std::clamp(-std::ilogb(longest), -1000, 1000)) : 1.0;
}

/// The scale of the box around positions.
inline double unitScaleOf(const std::vector<Eigen::Vector3d>& positions)
{
  Bounds bounds;
  for (const Eigen::Vector3d& position : positions)
  {
    bounds.extend(position);
  }
  return unitScale(bounds);
}

/**
 * A coordinate of a sample times a scale. Coordinates beyond 1e90 unit sizes are cut off there,
 * where every winding number has long been 0, so that cubes of distances stay finite.
 */
inline double scaledCoordinate(double coordinate, double scale)
{
  constexpr double farthest = 1e90;
  return std::clamp(coordinate * scale, -farthest, farthest);
}

/// Takes a component of a gradient from scaled coordinates to the caller's. The result is cut off
/// at the largest double, which gradients in very small coordinates may exceed.
inline double unscaledGradient(double gradient, double scale)
{
  constexpr double largest = std::numeric_limits<double>::max();
  return std::clamp(gradient * scale, -largest, largest);
}

inline void scaleSamples(const SampleBlock& block, double scale, SampleBlock& scaled)
{
  const auto apply = [&](const double(&from)[SampleBlock::capacity], double* to)
  {
    for (std::size_t i = 0; i < block.count; ++i)
    {
      to[i] = scaledCoordinate(from[i], scale);
    }
  };
  apply(block.x, scaled.x);
  apply(block.y, scaled.y);
  apply(block.z, scaled.z);
  scaled.count = block.count;
}

} // namespace winding
