// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sums/DirectSumKernels.h"
#include "sums/GradientKernels.h"

#include <algorithm>

/**
 * @file
 * The inner loops of dipoles that are spread over a length e (SolidAngle.h), compiled once per
 * instruction set and chosen at run time (Highway). They are vectorised over samples; sources are
 * broadcast one after the other, in their order.
 *
 * Guaranteed, for t = |p − q| / e: (1) values are right to 1e-14 of S |m|/|d|², the largest that a
 * dipole of any direction gives there, and gradients to 1e-14 of S |m|/|d|³ (measured:
 * tests/core/sums/RegularizedKernelsTest.cxx);
 * (2) from t = pureFrom on values and gradients have the bits of addDipoles() and
 * addDipoleGradients(); (3) a sample's bits do not depend on neighbouring samples.
 *
 * A vector of samples that all lie beyond pureFrom costs what it costs with pure dipoles, any other
 * vector up to five times as much.
 */
namespace winding
{

/// The t from which on 1 − S(t) is less than half a unit in the last place of 1.
constexpr double pureFrom = 6.3;

/// The inverse of a length as kernels take it: a point that is not spread counts as spread over
/// next to nothing.
inline double inverseOfLength(double length)
{
  return std::min(1 / length, 1e300);
}

/// Adds S(t) m·d/|d|³, d = p − q, of dipoles m at p for samples q. The share is 0 at the point
/// itself and where the cube of the distance underflows. There is one inverse length for each
/// dipole, from inverseOfLength().
void addRegularizedDipoles(const KernelDipole* dipoles, const double* inverseLengths,
  std::size_t count, const SampleBlock& samples, KernelSums& sums);

/// Adds what addRegularizedDipoles() adds in single precision, in the way of addDipolesInSingle().
/// The relative error of each share is up to 1e-6.
void addRegularizedDipolesInSingle(const KernelDipole* dipoles, const std::array<float, 3>* moments,
  const double* inverseLengths, std::size_t count, const SampleBlock& samples, KernelSums& sums);

/**
 * Adds the gradients of S(t) m·d/|d|³ with respect to q,
 *
 *   ((3 S − t S') (m·d) d / |d|² − S m) / |d|³,   t S' = 4/√π t³ exp(−t²).
 *
 * The gradient at the point itself is −4/(3√π) m/e³, and 0 if the point is not spread.
 */
void addRegularizedDipoleGradients(const KernelDipole* dipoles, const double* inverseLengths,
  std::size_t count, const SampleBlock& samples, GradientSums& sums);

} // namespace winding
