// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/VtkVersions.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace winding
{

/// Returns when `data` was modified, the arrays within its cells included: vtkCellArray::GetMTime()
/// leaves those out.
inline vtkMTimeType modifiedTimeOf(vtkDataObject* data)
{
  vtkMTimeType time = data->GetMTime();
  const auto add = [&time](vtkObject* part)
  {
    time = part ? std::max(time, part->GetMTime()) : time;
  };
  const auto addCells = [&add](vtkCellArray* cells)
  {
    if (cells)
    {
      add(cells->GetConnectivityArray());
      add(cells->GetOffsetsArray());
    }
  };
  if (auto* polyData = vtkPolyData::SafeDownCast(data))
  {
    for (vtkCellArray* cells :
      {polyData->GetVerts(), polyData->GetLines(), polyData->GetPolys(), polyData->GetStrips()})
    {
      addCells(cells);
    }
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    addCells(grid->GetCells());
    add(cellTypesOf(grid));
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
    for (vtkCellArray* faces : faceListsOf(grid))
    {
      addCells(faces);
    }
#else
    add(grid->GetFaces());
    add(grid->GetFaceLocations());
#endif
  }
  return time;
}

} // namespace winding
