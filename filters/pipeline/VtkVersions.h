// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkCellArray.h"
#include "vtkIdTypeArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <array>

/**
 * @file
 * The differences between the VTK versions that this project builds with (9.1 and newer) have their
 * place here.
 */
namespace winding
{

/// Whether a filter was told to stop. vtkAlgorithm::CheckAbort came between VTK 9.2 and 9.3; where
/// it exists, it also asks the filters downstream.
template <class Algorithm> auto isAborted(Algorithm* filter, int) -> decltype(filter->CheckAbort())
{
  return filter->CheckAbort();
}

template <class Algorithm> bool isAborted(Algorithm* filter, long)
{
  return filter->GetAbortExecute() != 0;
}

template <class Algorithm> bool isAborted(Algorithm* filter)
{
  return isAborted(filter, 0) || filter->GetAbortExecute() != 0;
}

///@{
/// Makes room for `count` points or ids; newer versions of VTK have another name for it.
template <class List>
auto reserve(List* list, vtkIdType count, int) -> decltype(list->Reserve(count), void())
{
  list->Reserve(count);
}
template <class List> void reserve(List* list, vtkIdType count, long)
{
  list->Allocate(count);
}
template <class List> void reserve(List* list, vtkIdType count)
{
  reserve(list, count, 0);
}
///@}

/// The types of a grid's cells, one for each; null where there are none.
inline vtkDataArray* cellTypesOf(vtkUnstructuredGrid* grid)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  return grid->GetCellTypes();
#else
  return grid->GetCellTypesArray();
#endif
}

/// The lists of the faces of polyhedra that are cell arrays, as they are from VTK 9.4 on; null
/// before, and where there are none.
inline std::array<vtkCellArray*, 2> faceListsOf(vtkUnstructuredGrid* grid)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
  return {grid->GetPolyhedronFaceLocations(), grid->GetPolyhedronFaces()};
#else
  static_cast<void>(grid);
  return {};
#endif
}

/// Whether a cell has faces as its type asks for: a polyhedron has them in the grid's lists, whose
/// offsets are valid, and any other cell has none. The ids of the faces' points may be any.
inline bool hasFacesOfItsType(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  const bool isPolyhedron = grid->GetCellType(cell) == VTK_POLYHEDRON;
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
  const auto [locations, faces] = faceListsOf(grid);
  if (!locations || !faces || locations->GetNumberOfCells() == 0)
  {
    return !isPolyhedron;
  }
  if (cell >= locations->GetNumberOfCells())
  {
    return false;
  }
  vtkIdType count;
  const vtkIdType* numbers;
  locations->GetCellAtId(cell, count, numbers);
  return isPolyhedron == (count > 0) && std::all_of(numbers, numbers + count,
                                          [lists = faces](vtkIdType face) {
                                            return face >= 0 && face < lists->GetNumberOfCells();
                                          });
#else
  vtkIdTypeArray* const locations = grid->GetFaceLocations();
  vtkIdTypeArray* const faces = grid->GetFaces();
  if (!locations || !faces)
  {
    return !isPolyhedron;
  }
  if (cell >= locations->GetNumberOfValues())
  {
    return false;
  }
  vtkIdType at = locations->GetValue(cell);
  const vtkIdType end = faces->GetNumberOfValues();
  if (!isPolyhedron || at < 0 || at >= end)
  {
    return !isPolyhedron && at == -1;
  }
  // The list has the number of faces, then of each face its size and its ids.
  const vtkIdType count = faces->GetValue(at++);
  if (count < 1)
  {
    return false;
  }
  for (vtkIdType left = count; left > 0; --left)
  {
    if (at >= end || faces->GetValue(at) < 0 || faces->GetValue(at) > end - at - 1)
    {
      return false;
    }
    at += 1 + faces->GetValue(at);
  }
  return true;
#endif
}

} // namespace winding
