// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

/**
 * @file
 * Cells by the numbers that VTK has for their types (vtkCellType.h), known without VTK. The corners
 * of a curved cell are its first points.
 */
namespace winding
{

constexpr int polyhedronType = 42, quadraticPolygonType = 36, firstBezierType = 75;

/// Returns the dimension of cells of a type, 0 to 3; −1 for a type that VTK has no cells of.
int dimensionOf(int cellType);

/// Returns the type of the cells with straight edges between the same corners: the type itself,
/// unless its cells are curved.
int straightTypeOf(int cellType);

/// Returns whether cells of a type have edges that need not be straight lines.
inline bool isCurved(int cellType)
{
  return straightTypeOf(cellType) != cellType;
}

/// Returns the least number of points of a cell of a type; 0 where that varies.
std::int64_t fewestPointsOf(int cellType);

/**
 * Returns whether a cell of a type can have `points` points. Polygons and the like can have any
 * number, Lagrange and Bézier cells the number by their degrees along the three axes. Null degrees
 * are equal ones.
 */
bool canHavePoints(int cellType, std::int64_t points, const double* degrees = nullptr);

/// The faces of cells of a type: the numbers of corners, face after face, where −1 ends each.
/// Counter-clockwise seen from outside.
using FaceTable = std::vector<int>;

/// Returns the faces of tetrahedra (10), voxels, hexahedra, wedges, pyramids, pentagonal and
/// hexagonal prisms (16); none for other types.
const FaceTable& facesOf(int cellType);

} // namespace winding
