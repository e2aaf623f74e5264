#pragma once

#include "vtkType.h"

namespace winding
{

/// The dimension of cells of a type of VTK, 0 to 3; −1 for a type that VTK has no cells of.
int dimensionOf(int cellType);

/**
 * Whether a cell of a type can have so many points. Polygons and the like can have any number,
 * Lagrange and Bézier cells those of their degrees along the three axes; null degrees are equal
 * ones.
 */
bool canHavePoints(int cellType, vtkIdType points, const double* degrees);

} // namespace winding
