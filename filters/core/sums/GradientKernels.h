// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Pi.h"
#include "source/UnitScale.h"
#include "sums/KernelTypes.h"

#include <cstddef>

/**
 * @file
 * The inner loops of gradients, compiled once per instruction set and chosen at run time (Highway).
 * They are vectorised over samples; sources are broadcast one after the other, in their order.
 *
 * A share that is larger than 1e290 or not a number counts as 0, so that sums stay finite at the
 * sources themselves, and where squares and cubes of distances leave the range of double.
 */
namespace winding
{

/// The edge from u to v, which are in scaled coordinates.
inline KernelEdge kernelEdge(const Eigen::Vector3d& u, const Eigen::Vector3d& v, int multiplicity)
{
  return {{u[0], u[1], u[2]}, {v[0], v[1], v[2]}, {v[0] - u[0], v[1] - u[1], v[2] - u[2]},
    multiplicity / (4 * pi)};
}

/// Writes sums for samples in scaled coordinates as gradients in the caller's coordinates.
inline void storeGradients(
  const GradientSums& sums, std::size_t count, double scale, double* gradients)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    gradients[3 * i] = unscaledGradient(sums.x[i], scale);
    gradients[3 * i + 1] = unscaledGradient(sums.y[i], scale);
    gradients[3 * i + 2] = unscaledGradient(sums.z[i], scale);
  }
}

/// Adds the gradients that boundary edges give (BoundaryGradient.h).
void addEdgeGradients(
  const KernelEdge* edges, std::size_t count, const SampleBlock& samples, GradientSums& sums);

/// Adds ∇ m·d/|d|³ = (3 (m·d) d / |d|² − m) / |d|³, d = p − q, of dipoles m at p for samples q.
void addDipoleGradients(
  const KernelDipole* dipoles, std::size_t count, const SampleBlock& samples, GradientSums& sums);

} // namespace winding
