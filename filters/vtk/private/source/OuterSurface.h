// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/CellCounts.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWindingABINamespace.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkPointSet;
class vtkPolyData;
class vtkUnsignedCharArray;
VTK_ABI_NAMESPACE_END

namespace winding
{

/// Counts the lines and single points of a mesh.
void countLoose(vtkPointSet* mesh, CellCounts& counts);

/// Returns whether another piece of the data has a cell too, or it is hidden or refined. `flags` is
/// the ghost array of the cells, or null.
bool isGhostCell(vtkUnsignedCharArray* flags, vtkIdType cell);

/**
 * Returns the cells of a data set that make its surface. Ghosts are not among them. Where a mesh
 * has cells of two and of three dimensions, cells of one of these kinds are left out and counted.
 * `takesFaces` says that cells of three dimensions are, not of two. Returns the data set itself if
 * no cell is left out. Throws Refusal, about data of that name, where some are left out and cells
 * cannot be followed (CellChecks.h).
 */
vtkSmartPointer<vtkPointSet> ownCellsOf(
  vtkPointSet* mesh, bool takesFaces, const std::string& name, CellCounts& counts);

/// Returns a mesh with the numbers of its cells and points as arrays of a name, which come along
/// when VTK makes other data sets of it.
vtkSmartPointer<vtkPointSet> withNumbers(vtkPointSet* mesh, const char* name);

/**
 * Returns the outer surface of a mesh as MeshSkin.h has it. Its cells were checked (CellChecks.h).
 * `keepsPoints` has curved faces divided at their own nodes only.
 */
vtkSmartPointer<vtkPolyData> outerSurfaceOf(
  vtkPointSet* mesh, bool keepsPoints, CellCounts& counts);

} // namespace winding
