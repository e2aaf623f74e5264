// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"

#include <cstddef>

namespace winding
{

/// A crossing of a surface with an edge of a cell, and the surface's unit normal there, of either
/// sense; 0 if it is not known.
struct HermiteCrossing
{
  Eigen::Vector3d position;
  Eigen::Vector3d normal;
};

/**
 * The point of a cell that is nearest to the planes through all crossings: the minimum of the
 * quadratic error function, the sum of the squared distances from the planes (Ju, Losasso,
 * Schaefer, Warren, Dual contouring of Hermite data, 2002). On two planes it lies on their common
 * line, on three it is the corner.
 *
 * Directions in which the planes do not decide enough, where an eigenvalue of the function is less
 * than leastEigenvalue of the largest, are dropped: the point stays at the mean of the crossings
 * along them. Where the minimum is outside the cell, the point is the one of the cell with the
 * least error.
 *
 * The cell is a box that has all crossings on its edges, one or more. The point
 * keeps 2⁻¹² of the cell's size away from its faces.
 */
Eigen::Vector3d featureVertex(
  const HermiteCrossing* crossings, std::size_t count, const Bounds& cell);

/// Two planes have this ratio of eigenvalues if they form an angle of 8 degrees.
constexpr double leastEigenvalue = 0.005;

} // namespace winding
