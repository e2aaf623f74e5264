// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/probe/InsidePart.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkThreshold.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace winding
{

namespace
{

bool isOfPoints(vtkDataSet* data)
{
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    if (data->GetCellType(i) != VTK_POLY_VERTEX)
    {
      return false;
    }
  }
  return vtkPointSet::SafeDownCast(data) && data->GetNumberOfPoints() > 0;
}

/// The points of a data set, with a vertex each.
vtkSmartPointer<vtkDataSet> verticesOf(vtkPointSet* data)
{
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(data->GetNumberOfPoints(), data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    cells->InsertNextCell(1, &i);
  }
  vtkSmartPointer<vtkPointSet> vertices;
  if (vtkPolyData::SafeDownCast(data))
  {
    auto polyData = vtkSmartPointer<vtkPolyData>::New();
    polyData->SetVerts(cells);
    vertices = polyData;
  }
  else
  {
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    grid->SetCells(VTK_VERTEX, cells);
    vertices = grid;
  }
  vertices->SetPoints(data->GetPoints());
  vertices->GetPointData()->ShallowCopy(data->GetPointData());
  return vertices;
}

/// Cells whose points are all inside.
void findCells(vtkDataSet* data, const unsigned char* inside, vtkIdList* found)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    data->GetCellPoints(cell, ids);
    const bool isInside =
      std::all_of(ids->begin(), ids->end(), [inside](vtkIdType id) { return inside[id] != 0; });
    if (isInside && ids->GetNumberOfIds() > 0)
    {
      found->InsertNextId(cell);
    }
  }
}

vtkSmartPointer<vtkDataSet> cellsOf(vtkDataSet* data, vtkIdList* cells)
{
  if (auto* from = vtkPolyData::SafeDownCast(data))
  {
    auto part = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetDataType(from->GetPoints() ? from->GetPoints()->GetDataType() : VTK_FLOAT);
    part->SetPoints(points);
    part->AllocateProportional(from, 1.0);
    part->GetPointData()->CopyAllOn();
    part->GetCellData()->CopyAllOn();
    part->GetPointData()->CopyAllocate(from->GetPointData());
    part->GetCellData()->CopyAllocate(from->GetCellData());
    part->CopyCells(from, cells);
    part->Squeeze();
    return part;
  }
  // By an array that is gone again afterwards: vtkExtractCells would leave one of its own.
  const char* const maskName = "vtkWindingNumberProbe::Kept";
  vtkNew<vtkUnsignedCharArray> mask;
  mask->SetName(maskName);
  mask->SetNumberOfTuples(data->GetNumberOfCells());
  mask->FillValue(0);
  for (const vtkIdType cell : *cells)
  {
    mask->SetValue(cell, 1);
  }
  auto marked = vtkSmartPointer<vtkDataSet>::Take(data->NewInstance());
  marked->ShallowCopy(data);
  marked->GetCellData()->AddArray(mask);
  vtkNew<vtkThreshold> threshold;
  threshold->SetInputData(marked);
  threshold->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, maskName);
  threshold->SetThresholdFunction(vtkThreshold::THRESHOLD_UPPER);
  threshold->SetUpperThreshold(1);
  if (!vtkPointSet::SafeDownCast(data))
  {
    // Points that are computed would be rounded else.
    threshold->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  }
  threshold->Update();
  vtkSmartPointer<vtkUnstructuredGrid> part = threshold->GetOutput();
  part->GetCellData()->RemoveArray(maskName);
  return part;
}

} // namespace

vtkSmartPointer<vtkDataSet> insidePart(vtkDataSet* data, const unsigned char* inside, bool atCells)
{
  vtkSmartPointer<vtkDataSet> whole = data;
  if (!atCells && isOfPoints(data))
  {
    whole = verticesOf(vtkPointSet::SafeDownCast(data));
  }
  vtkNew<vtkIdList> cells;
  if (!atCells)
  {
    findCells(whole, inside, cells);
  }
  else
  {
    for (vtkIdType cell = 0; cell < whole->GetNumberOfCells(); ++cell)
    {
      if (inside[cell])
      {
        cells->InsertNextId(cell);
      }
    }
  }
  vtkSmartPointer<vtkDataSet> part = cellsOf(whole, cells);
  part->GetFieldData()->PassData(data->GetFieldData());
  return part;
}

} // namespace winding
