// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkType.h"
#include "vtkWindingABINamespace.h"

#include <cstdint>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
class vtkUnstructuredGrid;
VTK_ABI_NAMESPACE_END

namespace winding
{

/**
 * @file
 * Data sets may contradict themselves, and VTK's classes follow what they say, into memory that is
 * not theirs. These functions throw Refusal, one line with the given name of the data, for such
 * data sets.
 */

/// Refuses an `extent` of six numbers that ends before it begins by more than one. VTK may count
/// points of it all the same, and ends the process where an image is to have it (VTK 9.6).
void checkExtent(const int* extent, const std::string& name);

/**
 * Refuses offsets of cells that lead out of their list of ids, cells without a type, grids whose
 * extents end before they begin, and structured and rectilinear grids with fewer points or
 * coordinates than their extents ask for. It does not look at ids.
 */
void checkStructure(vtkDataSet* data, const std::string& name);

/**
 * Refuses all that checkStructure() does, ids of points that do not exist, cells of types that VTK
 * does not know or with a number of points that their type does not have, and polyhedra with faces
 * that are not there or have other points than the polyhedron.
 */
void checkCells(vtkDataSet* data, const std::string& name);

/// Refuses what checkCells() does, except cells of a vtkPolyData with too few points: they do no
/// harm where no cell is asked for. A line of one point is a common way to give a single point.
void checkUnusedCells(vtkDataSet* data, const std::string& name);

/// Refuses arrays with fewer values than there are points or cells.
void checkArrays(vtkDataSet* data, const std::string& name);

/// Appends the faces of a polyhedron as MeshSkin.h has them: their number, then of each the number
/// of its points and their ids.
void appendFaces(vtkUnstructuredGrid* mesh, vtkIdType cell, std::vector<std::int64_t>& ids);

} // namespace winding
