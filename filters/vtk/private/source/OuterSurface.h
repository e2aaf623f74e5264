// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Message.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWindingABINamespace.h"

#include <cstddef>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPointSet;
class vtkPolyData;
class vtkUnsignedCharArray;
VTK_ABI_NAMESPACE_END

namespace winding
{

/// Counts of cells whose part in a source may differ from what their owner expects.
struct CellCounts
{
  std::size_t turned = 0;  ///< cells with volume at the outer surface, ordered the other way round
  std::size_t leftOut = 0; ///< cells of two dimensions where there are three, or the latter
  std::size_t loose = 0;   ///< lines and single points, where there are faces or cells with volume
  std::size_t flat = 0;    ///< curved faces that no division brings near enough to their shape
};

/// Returns what a user should know of cells that were counted.
std::vector<Message> notesOn(const CellCounts& counts);

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

/**
 * Returns the outer surface of a mesh whose cells were checked (CellChecks.h).
 *
 * - A face of a cell with volume is turned away from its own cell. A polyhedron's faces are first
 *   oriented like each other. So any order of nodes will do.
 * - Cells that touch have no wall between them, whether they share points or not (Seams.h).
 * - Curved faces are divided until they are within a thousandth of the mesh's diagonal of their
 *   shape, or into 32 pieces along each edge. `keepsPoints` has each divided at its own nodes only.
 */
vtkSmartPointer<vtkPolyData> outerSurfaceOf(
  vtkPointSet* mesh, bool keepsPoints, CellCounts& counts);

} // namespace winding
