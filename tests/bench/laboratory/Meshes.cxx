// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "laboratory/Meshes.h"

#include "input/ReadInput.h"
#include "laboratory/BenchOptions.h"
#include "program/Failure.h"
#include "program/Messages.h"

#include "base/Refusal.h"

#include "vtkCellArray.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace
{

/// Calls append(ids, i) for each corner i of a cell that ends a triangle of its fan or strip.
template <class Append> void eachCell(vtkCellArray* cells, const Append& append)
{
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, size, ids);
    for (vtkIdType i = 2; i < size; ++i)
    {
      append(ids, i);
    }
  }
}

} // namespace

Triangles trianglesOf(vtkPointSet* data)
{
  Triangles result;
  vtkNew<vtkDataSetSurfaceFilter> skin;
  auto* surface = vtkPolyData::SafeDownCast(data);
  if (!surface)
  {
    skin->SetInputData(data);
    skin->Update();
    surface = skin->GetOutput();
  }
  for (vtkIdType id = 0; id < surface->GetNumberOfPoints(); ++id)
  {
    double point[3];
    surface->GetPoint(id, point);
    result.coordinates.insert(result.coordinates.end(), point, point + 3);
  }
  const auto add = [&result](vtkIdType a, vtkIdType b, vtkIdType c)
  {
    result.ids.insert(result.ids.end(), {a, b, c});
  };
  eachCell(surface->GetPolys(),
    [&add](const vtkIdType* ids, vtkIdType i) { add(ids[0], ids[i - 1], ids[i]); });
  eachCell(surface->GetStrips(),
    [&add](const vtkIdType* ids, vtkIdType i)
    {
      const bool turned = i % 2 == 1;
      add(ids[i - 2], ids[turned ? i : i - 1], ids[turned ? i - 1 : i]);
    });
  return result;
}

vtkSmartPointer<vtkPolyData> polyDataOf(const Triangles& triangles)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(triangles.points()));
  for (std::size_t i = 0; i < triangles.points(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), &triangles.coordinates[3 * i]);
  }
  vtkNew<vtkCellArray> cells;
  for (std::size_t i = 0; i < triangles.triangles(); ++i)
  {
    const std::int64_t* const ids = &triangles.ids[3 * i];
    cells->InsertNextCell({ids[0], ids[1], ids[2]});
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(cells);
  return surface;
}

void forEachMesh(const BenchOptions& options, Messages& messages,
  const std::function<void(const std::string& file, const Triangles& triangles)>& measure)
{
  for (const std::string& file : options.files)
  {
    const Triangles triangles = trianglesOf(readPoints(file, messages));
    messages.throwIfError(file);
    if (triangles.triangles() == 0)
    {
      throw Failure(EXIT_REFUSED, file, "has no triangles; the laboratory measures surfaces");
    }
    try
    {
      measure(file, triangles);
    }
    catch (const winding::Refusal& refusal)
    {
      throw Failure(EXIT_REFUSED, file, refusal.what());
    }
  }
}
