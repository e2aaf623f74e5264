// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkType.h"
#include "vtkWindingABINamespace.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkCell;
VTK_ABI_NAMESPACE_END

namespace winding
{

/// The dimension of cells of a type of VTK, 0 to 3; −1 for a type that VTK has no cells of.
int dimensionOf(int cellType);

/// The type of the cells that have straight edges between the same corners: the type itself, unless
/// its cells are curved. The corners of curved cells are their first points.
int straightTypeOf(int cellType);

/// Whether cells of a type have edges that need not be straight lines.
inline bool isCurved(int cellType)
{
  return straightTypeOf(cellType) != cellType;
}

/// Returns the number of corners of a face, whose other points come after them.
vtkIdType cornersOf(vtkCell* face);

/// The least number of points that a cell of a type has; 0 for types without a number of their own.
vtkIdType fewestPointsOf(int cellType);

/**
 * Returns whether a cell of a type can have `points` points. Polygons and the like can have any
 * number, Lagrange and Bézier cells the number by their degrees along the three axes; null degrees
 * are equal ones.
 */
bool canHavePoints(int cellType, vtkIdType points, const double* degrees);

} // namespace winding
