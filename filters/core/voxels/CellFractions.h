// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/InsideRule.h"
#include "base/Message.h"
#include "field/Field.h"
#include "voxels/CellShape.h"

#include <cstddef>
#include <vector>

namespace winding
{

/// The numbers of cells whose fraction is no share of their volume.
struct CellsWithoutFraction
{
  std::size_t flat = 0;    ///< without volume: 1 or 0, as their middle is inside or not
  std::size_t open = 0;    ///< polyhedra with a face that is missing or turned: NaN
  std::size_t curved = 0;  ///< with curved faces, which count as straight between corners
  std::size_t nowhere = 0; ///< with points that are NaN or infinite, or without points: NaN
};

/**
 * Writes the share of each cell that is inside by the rule, from 0 to 1.
 *
 * A cell is the sum of cones over the triangles of its faces, from a point of it that lies off the
 * source (apex). A face that is planar is cut into a fan, any other into triangles around the mean
 * of its corners, which leaves a hexahedron the volume that its trilinear map gives it (Dukowicz,
 * J. Comput. Phys. 74, 1988). Neighbors with common corners cut a face in the same way, up to
 * rounding, so fractions times volumes of a mesh add up to the volume of what is inside. Cones
 * count by their signed volume, so cells need neither be convex nor turned the right way round.
 *
 * Where w changes at triangles only, as for a closed surface, the share is exact up to rounding
 * (ConeShare.h), whatever the rule, and however many solids overlap. It is near that where hundreds
 * of triangles all pass through each other in a cell. A cell whose box no triangle meets takes one
 * sample.
 *
 * Elsewhere, near holes and for clouds, cells are divided where w is near the threshold, a triangle
 * takes it there, an edge of the boundary lies, or a point is near: into their cones, and these
 * twice into eight. w is interpolated linearly over a part that no triangle meets, and taken to
 * change at triangles only in any other. Measured, in cells of a sixth of a sphere: 0.006 at most
 * and 0.0014 on average for a sphere with a hole, 0.02 and 0.006 for a cloud of 400 points.
 *
 * A cell without volume (less than 1e-13 of the cube of its box's diagonal) counts as its middle: 0
 * or 1. A cell with points that are not finite gets NaN, and so does one whose faces do not close,
 * for it bounds nothing. Shares nearer to 0 or 1 than 1e-12, which rounding makes where a solid
 * only touches a cell, are 0 and 1.
 *
 * Guaranteed: the bits depend on the source and the cell only, not on other cells, the executor or
 * its threads, and not on the order of triangles and points; except that a far field makes them
 * depend on other cells (Field).
 *
 * Takes time in proportion to the cells, and to the triangles in each times the triangles of its
 * faces. Progress goes through the executor's share. Throws Interrupted.
 */
CellsWithoutFraction evaluateFractions(const Field& field, const CellShapes& cells,
  const InsideTest& isInside, float* fractions, Executor& executor);

/// Returns warnings where the fraction of some of `cells` cells is no share of a volume.
std::vector<Message> warningsOf(const CellsWithoutFraction& counts, std::size_t cells);

/// Returns the memory of evaluateFractions() for `cells` cells, in addition to the field at a
/// sample for each.
std::size_t bytesOfCellFractions(const Field& field, std::size_t cells);

} // namespace winding
