// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "voxels/LocalCell.h"

#include <array>
#include <cstdint>
#include <vector>

namespace winding
{

/// A part of a cell that is divided, a tetrahedron in the cell's coordinates.
struct CellPart
{
  std::array<Eigen::Vector3d, 4> corners;
  std::uint32_t cell; ///< its number among those divided at a time
  double volume;      ///< six times the volume, signed
  CellState state;    ///< clear, touched or onRim, by triangles only

  /// A point without a pattern, so that it lies on no triangle where meshes are regular.
  Eigen::Vector3d apex() const
  {
    return 0.2437 * corners[0] + 0.2561 * corners[1] + 0.2389 * corners[2] + 0.2613 * corners[3];
  }
};

/// Returns the box of a part, which is not in the cell's coordinates.
Bounds boxOf(const CellPart& part, const LocalCell& cell);

/// Adds the cones of a cell from its middle; `number` is the cell's.
void addCones(const LocalCell& cell, std::uint32_t number, std::vector<CellPart>& to);

/// Adds the eight parts that the middles of the sides make (Bey, Computing 55, 1995).
void addEighths(const CellPart& part, std::vector<CellPart>& to);

/// Returns the part of a tetrahedron where a linear function is positive, from its values at the
/// corners.
double positivePart(std::array<double, 4> values);

} // namespace winding
