#pragma once

#include "sums/KernelTypes.h"

#include <array>
#include <cstddef>

/**
 * @file
 * The inner loops of the direct sums, compiled once per instruction set and chosen at run time
 * (Highway). Vectorised over samples; sources are broadcast one after the other, in their order.
 */
namespace winding
{

/// values[i] = argument of product i / 2π + its turns: the sum of all Ω / 4π.
void sumAngles(const AngleProducts& products, std::size_t count, double* values);

void multiplyAngles(const KernelTriangle* triangles, std::size_t count, const SampleBlock& samples,
  AngleProducts& products);

/**
 * The same, and marks the samples that lie on a triangle, its edges included, within rounding: those
 * where numerator and denominator are both less than suspectAngle times |a||b||c|; and those at a
 * vertex, which sides that were rounded apart may pass on either side: nearer than suspectAngle times
 * |a| + |b| + |c|.
 */
void multiplyAnglesWatching(const KernelTriangle* triangles, std::size_t count,
  const SampleBlock& samples, AngleProducts& products);

/// Rounding errors of the two are some 1e-16 times |a||b||c| times the ratio of the coordinates to
/// the distances; what passes has angles right to 1e-10 and better.
constexpr double suspectAngle = 1e-6;

void addDipoles(
  const KernelDipole* dipoles, std::size_t count, const SampleBlock& samples, KernelSums& sums);

/**
 * The same in single precision from offsets in double, summed in double every few dipoles: relative
 * errors of some 1e-7 of each share, however near the sample. moments: those of the dipoles in single
 * precision.
 */
void addDipolesInSingle(const KernelDipole* dipoles, const std::array<float, 3>* moments,
  std::size_t count, const SampleBlock& samples, KernelSums& sums);

/// Name of the instruction set that this machine's kernels use, such as "AVX2".
const char* kernelInstructionSet();

} // namespace winding
