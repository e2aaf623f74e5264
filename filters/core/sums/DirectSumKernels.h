// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sums/KernelTypes.h"
#include "sums/SolidAngle.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>

/**
 * @file
 * The inner loops of the direct sums, compiled once per instruction set and chosen at run time
 * (Highway). They are vectorised over samples; sources are broadcast one after the other, in their
 * order.
 */
namespace winding
{

/// Returns the triangle of three corners in scaled coordinates.
inline KernelTriangle kernelTriangle(
  const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const Eigen::Vector3d normal = triangleNormal<double>(a, b, c);
  KernelTriangle triangle;
  std::copy_n(a.data(), 3, triangle.a);
  std::copy_n(b.data(), 3, triangle.b);
  std::copy_n(c.data(), 3, triangle.c);
  std::copy_n(normal.data(), 3, triangle.normal);
  const double longest =
    std::max({(b - a).squaredNorm(), (c - a).squaredNorm(), (c - b).squaredNorm()});
  triangle.isThin = longest * longest > 16 * 16 * normal.squaredNorm();
  return triangle;
}

/// The dipole at a point in scaled coordinates, of a normal whose length is the area / 4π there.
inline KernelDipole kernelDipole(const Eigen::Vector3d& position, const Eigen::Vector3d& moment)
{
  return {{position.x(), position.y(), position.z()}, {moment.x(), moment.y(), moment.z()}};
}

/// Writes the sum of all Ω / 4π of each sample: values[i] = argument of product i / 2π + its turns.
void sumAngles(const AngleProducts& products, std::size_t count, double* values);

/// Multiplies the product of each sample by the factors of all triangles (DirectSum.h).
void multiplyAngles(const KernelTriangle* triangles, std::size_t count, const SampleBlock& samples,
  AngleProducts& products);

/**
 * Multiplies as multiplyAngles() does, and marks the samples that lie on a triangle, its edges
 * included, within rounding: samples where the numerator's size and the denominator are both at
 * most suspectAngle times |a||b||c|, and samples at a vertex, which sides that were rounded apart
 * may pass on either side, not farther from it than suspectAngle times |a| + |b| + |c|.
 */
void multiplyAnglesWatching(const KernelTriangle* triangles, std::size_t count,
  const SampleBlock& samples, AngleProducts& products);

/// The bound for samples that multiplyAnglesWatching() marks. It is far above rounding errors of
/// numerator and denominator, which are some 1e-16 times |a||b||c|.
constexpr double suspectAngle = 1e-6;

/// Adds m·d/|d|³, d = p − q, of dipoles m at p for samples q; 0 at the point itself.
void addDipoles(
  const KernelDipole* dipoles, std::size_t count, const SampleBlock& samples, KernelSums& sums);

/**
 * Adds what addDipoles() adds in single precision, from offsets in double; the shares are summed in
 * double every few dipoles. The relative error of each share is some 1e-7, however near the sample.
 * `moments` are the dipoles' in single precision.
 */
void addDipolesInSingle(const KernelDipole* dipoles, const std::array<float, 3>* moments,
  std::size_t count, const SampleBlock& samples, KernelSums& sums);

/// The name of the instruction set that this machine's kernels use, such as "AVX2".
const char* kernelInstructionSet();

} // namespace winding
