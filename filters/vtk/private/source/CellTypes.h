#pragma once

#include "vtkType.h"

namespace winding
{

/// The dimension of cells of a type of VTK, 0 to 3; −1 for a type that VTK has no cells of.
int dimensionOf(int cellType);

/**
 * Returns whether a cell of a type can have `points` points. Polygons and the like can have any
 * number, Lagrange and Bézier cells the number by their degrees along the three axes; null degrees
 * are equal ones.
 */
bool canHavePoints(int cellType, vtkIdType points, const double* degrees);

} // namespace winding
