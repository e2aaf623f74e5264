// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Evaluator.h"
#include "base/RoundUp.h"

#include <algorithm>
#include <cstddef>

/**
 * @file
 * The types that the inner loops of all sums take, in scaled coordinates, and add to.
 */
namespace winding
{

/// The most sources per call, which fit into the first-level cache together with a block of
/// samples.
constexpr std::size_t kernelChunk = 128;

struct KernelTriangle
{
  double a[3], b[3], c[3];
  double normal[3]; ///< (b − a) × (c − a), from kernelTriangle()
  bool isThin;      ///< whether the longest side is over 16 times as long as the height on it
};

struct KernelDipole
{
  double position[3];
  double moment[3]; ///< normal · area / 4π
};

struct KernelEdge
{
  double from[3], to[3];
  double along[3]; ///< to − from
  double weight;   ///< multiplicity / 4π
};

/// The product of all factors up to now for each sample, up to a positive scale, and its lost
/// turns.
struct AngleProducts
{
  /// Sets the products of `samples` samples, rounded up to whole vectors, to 1; the rest stays
  /// uninitialised.
  explicit AngleProducts(std::size_t samples)
  {
    const std::size_t used = roundUp(samples, 8);
    std::fill_n(re, used, 1.0);
    for (double* values : {im, turns, suspect})
    {
      std::fill_n(values, used, 0.0);
    }
  }

  alignas(64) double re[SampleBlock::capacity];
  alignas(64) double im[SampleBlock::capacity];
  alignas(64) double turns[SampleBlock::capacity];
  /// Marks that are not 0 where a triangle is so near that rounding decides about its angle, see
  /// multiplyAnglesWatching().
  alignas(64) double suspect[SampleBlock::capacity];
};

struct KernelSums
{
  alignas(64) double sum[SampleBlock::capacity] = {};
};

/// Sums of gradients, one vector per sample.
struct GradientSums
{
  alignas(64) double x[SampleBlock::capacity] = {};
  alignas(64) double y[SampleBlock::capacity] = {};
  alignas(64) double z[SampleBlock::capacity] = {};
};

} // namespace winding
