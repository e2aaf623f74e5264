// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWindingABINamespace.h"

#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPointSet;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace winding
{

class Executor;

/// The cells of a data set that regions are made of, the first and the one past the last: polygons
/// and strips of polydata, all cells of other data.
std::pair<vtkIdType, vtkIdType> facesOf(vtkPointSet* data);

/// The solids that a surface is made of (SolidParts.h).
struct SolidCells
{
  std::vector<std::vector<vtkIdType>> cells; ///< by solid: polygons and strips, by their ids
  std::vector<char> isOpenPart;              ///< by solid: whether it is one of OpenParts.h
  std::vector<vtkIdType> unusable;           ///< polygons without a usable triangle, of no solid
};

/// Finds the solids of a surface. Strips belong to one solid. `ignoresOpenParts` leaves out open
/// parts inside of closed ones. Points up to `weldTolerance` from each other are one. Throws
/// Interrupted, and a Refusal if there is no usable polygon.
SolidCells solidCellsOf(
  vtkPolyData* surface, bool ignoresOpenParts, double weldTolerance, Executor& executor);

/**
 * Some of the cells of a data set, in their order, with the points that they use. The cells of
 * polydata are polygons and strips, and keep ids of points that do not exist. `newIds` is −1 for
 * each point between calls, or empty before the first: it is what makes many small regions of one
 * surface take no more time than one. `keepsPointData` has points keep their arrays, as clouds do.
 */
vtkSmartPointer<vtkPointSet> cellsOf(vtkPointSet* data, const std::vector<vtkIdType>& cells,
  std::vector<vtkIdType>& newIds, bool keepsPointData);

} // namespace winding
