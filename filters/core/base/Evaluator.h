// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>

namespace winding
{

/**
 * Up to `capacity` samples as structure of arrays, aligned and padded for SIMD: an evaluator may
 * read (and compute, and throw away) up to `capacity` entries, so all of them hold finite numbers.
 */
struct SampleBlock
{
  static constexpr std::size_t capacity = 256;

  alignas(64) double x[capacity] = {};
  alignas(64) double y[capacity] = {};
  alignas(64) double z[capacity] = {};
  std::size_t count = 0;

  void set(std::size_t i, const Eigen::Vector3d& position)
  {
    x[i] = position[0];
    y[i] = position[1];
    z[i] = position[2];
  }
};

/**
 * One method, bound to one source. Immutable once built: evaluate() may be called from any number
 * of threads at once, and the value of a sample does not depend on neighbouring samples.
 */
class Evaluator
{
public:
  virtual ~Evaluator() = default;

  /// Writes the winding number of each of block.count samples to values[0 … count − 1].
  virtual void evaluate(const SampleBlock& block, double* values) const = 0;
};

/// One method for gradients of winding numbers, bound to one source. Immutable once built, like an
/// Evaluator.
class GradientEvaluator
{
public:
  virtual ~GradientEvaluator() = default;

  /// Writes block.count gradients, three numbers each, in 1/(unit of the block's coordinates).
  virtual void evaluateGradients(const SampleBlock& block, double* gradients) const = 0;
};

} // namespace winding
