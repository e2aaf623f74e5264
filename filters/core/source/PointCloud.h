// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"

#include <cstddef>
#include <vector>

namespace winding
{

/// A clean oriented cloud, as sanitize() makes it: finite positions, unit normals, finite
/// non-negative areas; −0 does not occur.
struct PointCloud
{
  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Vector3d> normals; ///< as many as positions, or none when the input has none
  std::vector<double> areas;            ///< as many as positions, or none when the input has none
  /// Lengths over which points are spread (SolidAngle.h): one per point, or none for pure dipoles.
  /// A point of length 0 is a pure dipole, too. The input has no length 0: sanitize() leaves
  /// this empty.
  std::vector<double> regularizationLengths;
  Bounds bounds;

  std::size_t inputPoints = 0;
  std::size_t nonFinitePoints = 0;  ///< dropped: position, normal or area NaN or infinite
  std::size_t zeroNormalPoints = 0; ///< dropped: a normal of length 0 has no direction
  std::size_t badAreaPoints = 0;    ///< dropped: a negative area

  std::size_t dropped() const { return nonFinitePoints + zeroNormalPoints + badAreaPoints; }
};

} // namespace winding
