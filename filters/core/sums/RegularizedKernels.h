#pragma once

#include "sums/DirectSumKernels.h"
#include "sums/GradientKernels.h"

#include <algorithm>

/**
 * @file
 * The inner loops of dipoles that are spread over a length e (SolidAngle.h), compiled once per
 * instruction set and chosen at run time (Highway). Vectorised over samples; sources are broadcast one
 * after the other, in their order.
 *
 * Guaranteed, for t = |p − q| / e: (1) values are right to 1e-14 of S |m|/|d|², the largest that a
 * dipole of any direction gives there, and gradients to 1e-14 of S |m|/|d|³ (measured:
 * tests/core/sums/RegularizedKernelsTest.cxx);
 * (2) from t = pureFrom on they have the bits of addDipoles() and addDipoleGradients();
 * (3) a sample's bits do not depend on the samples beside it.
 *
 * Where a whole vector of samples lies beyond pureFrom they cost what pure dipoles do, else up to five
 * times as much.
 */
namespace winding
{

/// 1 − S(t) is less than half a unit in the last place of 1 from here on.
constexpr double pureFrom = 6.3;

/// What kernels take: a point that is not spread is one that is spread over next to nothing.
inline double inverseOfLength(double length)
{
  return std::min(1 / length, 1e300);
}

/// Adds S(t) m·d/|d|³, d = p − q, of dipoles m at p for samples q. At the point itself it is 0, as it is
/// where the cube of the distance underflows. inverseLengths: one for each dipole, of inverseOfLength().
void addRegularizedDipoles(const KernelDipole* dipoles, const double* inverseLengths,
  std::size_t count, const SampleBlock& samples, KernelSums& sums);

/// The same as addDipolesInSingle() does it: relative errors of up to 1e-6 of each share.
void addRegularizedDipolesInSingle(const KernelDipole* dipoles, const std::array<float, 3>* moments,
  const double* inverseLengths, std::size_t count, const SampleBlock& samples, KernelSums& sums);

/**
 * Adds the gradients of that with respect to q,
 *
 *   ((3 S − t S') (m·d) d / |d|² − S m) / |d|³,   t S' = 4/√π t³ exp(−t²).
 *
 * At the point itself it is −4/(3√π) m/e³, and 0 if the point is not spread.
 */
void addRegularizedDipoleGradients(const KernelDipole* dipoles, const double* inverseLengths,
  std::size_t count, const SampleBlock& samples, GradientSums& sums);

} // namespace winding
