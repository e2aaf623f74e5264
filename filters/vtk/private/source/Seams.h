// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkPointSet;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace winding
{

/**
 * Leaves out the seams between cells that touch but share no points, as between the pieces of a
 * file: polygons with the same corners in opposite senses, of cells with volume. They look like
 * walls to distances, counts and labels, though not to winding numbers.
 *
 * `surface` is the outer surface of `mesh`, with vtkOriginalCellIds, and looks outward. Returns
 * itself where there are no seams, and otherwise its other cells with their data, over all of its
 * points.
 */
vtkSmartPointer<vtkPolyData> withoutSeams(vtkPolyData* surface, vtkPointSet* mesh);

} // namespace winding
