// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkWindingABINamespace.h"

#include <cstddef>

VTK_ABI_NAMESPACE_BEGIN
class vtkPointSet;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace winding
{

/**
 * Turns the polygons of a mesh's outer surface that look into their own cell (OuterPolygons.h), by
 * the sign of the cell's volume. Cells have straight edges. A polyhedron's faces are first oriented
 * like each other. Returns the number of cells whose polygons were turned.
 */
std::size_t turnOutward(vtkPointSet* mesh, vtkPolyData* surface);

} // namespace winding
