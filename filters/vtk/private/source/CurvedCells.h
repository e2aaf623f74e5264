// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

#include <cstddef>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
class vtkUnstructuredGrid;
VTK_ABI_NAMESPACE_END

namespace winding
{

class OuterPolygons;

bool hasCurvedCells(vtkUnstructuredGrid* mesh);

/// Returns the same mesh with straight edges between the corners of its cells.
vtkSmartPointer<vtkUnstructuredGrid> straightened(vtkUnstructuredGrid* mesh);

/**
 * Divides the curved faces of a mesh. `polygons` come from the straightened mesh, and straight
 * ones stay. Faces that share an edge share the points on it. Distances and divisions are as for
 * outerSurfaceOf(). `keepsPoints` has each face divided at its own nodes only. Sets `flat` to the
 * number of faces that stay too far from their shape.
 */
vtkSmartPointer<vtkPolyData> dividedSurface(
  vtkUnstructuredGrid* mesh, const OuterPolygons& polygons, bool keepsPoints, std::size_t& flat);

} // namespace winding
