// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Evaluator.h"
#include "farfield/Expansions.h"
#include "farfield/MultipoleKernels.h"

#include <cstddef>

/**
 * @file
 * Gradients of the values that moments give, in single precision, compiled once per instruction set
 * and chosen at run time (Highway). Vectorised over samples.
 */
namespace winding
{

/**
 * The derivatives along x, y and z of the values that moments M of order P give: expansions D of
 * order P + 1, as Expansions.h stores them, to be evaluated like moments. They follow from
 * ∂z T_n^m = −T_{n+1}^m, (∂x−i∂y) T_n^m = T_{n+1}^{m−1} and (∂x+i∂y) T_n^m = −T_{n+1}^{m+1}:
 *
 *   Dx_{n+1}^m = (M_n^{m+1} − M_n^{m−1}) / 2,   Dy_{n+1}^m = −i (M_n^{m+1} + M_n^{m−1}) / 2,
 *   Dz_{n+1}^m = −M_n^m.
 *
 * Moments scaled by a radius r (MultipoleKernels.h) give derivatives scaled alike, whose values at
 * offset / r are to be divided by r².
 */
struct MomentDerivatives
{
  MomentDerivatives(int order, const float* moments);

  int order; ///< P + 1
  float x[coefficientCount(largestOrder + 1)];
  float y[coefficientCount(largestOrder + 1)];
  float z[coefficientCount(largestOrder + 1)];
};

/// One vector per sample, in single precision.
struct FloatGradientSums
{
  alignas(64) float x[SampleBlock::capacity] = {};
  alignas(64) float y[SampleBlock::capacity] = {};
  alignas(64) float z[SampleBlock::capacity] = {};
};

/// Adds the gradients that a node's moments give at samples. x, y, z: the samples' offsets from its
/// centre, divided by its radius, padded to whole vectors of 16.
void addMomentGradients(const MomentDerivatives& derivatives, float inverseRadius, const float* x,
  const float* y, const float* z, std::size_t count, FloatGradientSums& sums);

} // namespace winding
