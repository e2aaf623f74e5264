// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/OuterSurface.h"

#include "private/source/CellChecks.h"
#include "private/source/CellTypes.h"
#include "private/source/CurvedCells.h"
#include "private/source/OuterPolygons.h"
#include "private/source/OutwardPolygons.h"
#include "private/source/Seams.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkExplicitStructuredGrid.h"
#include "vtkExplicitStructuredGridToUnstructuredGrid.h"
#include "vtkExtractCells.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

namespace winding
{

namespace
{

/// Whether a data set has cells of two dimensions and of three. Polydata has none with volume.
bool isMixed(vtkPointSet* mesh)
{
  bool hasFaces = false, hasVolumes = false;
  const vtkIdType cells = vtkUnstructuredGrid::SafeDownCast(mesh) ? mesh->GetNumberOfCells() : 0;
  for (vtkIdType cell = 0; cell < cells && !(hasFaces && hasVolumes); ++cell)
  {
    const int dimension = dimensionOf(mesh->GetCellType(cell));
    hasFaces |= dimension == 2;
    hasVolumes |= dimension == 3;
  }
  return hasFaces && hasVolumes;
}

/// Returns the cells of a mesh, in an unstructured grid where VTK's surfaces have no numbers of
/// cells.
vtkSmartPointer<vtkPointSet> withNumbers(vtkPointSet* mesh)
{
  if (!vtkExplicitStructuredGrid::SafeDownCast(mesh))
  {
    return mesh;
  }
  vtkNew<vtkExplicitStructuredGridToUnstructuredGrid> cells;
  cells->SetInputData(mesh);
  cells->Update();
  return cells->GetOutput();
}

/// Returns the outer surface of cells without curves, as VTK finds it.
vtkSmartPointer<vtkPolyData> straightSurfaceOf(vtkPointSet* mesh)
{
  vtkNew<vtkDataSetSurfaceFilter> filter;
  filter->SetInputData(mesh);
  filter->PassThroughCellIdsOn();
  filter->PassThroughPointIdsOn();
  filter->Update();
  return filter->GetOutput();
}

} // namespace

std::vector<Message> notesOn(const CellCounts& counts)
{
  std::vector<Message> notes;
  if (counts.leftOut > 0)
  {
    notes.push_back(
      {"cells with and without volume are mixed", {{"choose which", {Parameter::surfaceCells}}},
        std::to_string(counts.leftOut) + " cells of the other kind are left out"});
  }
  if (counts.loose > 0)
  {
    notes.push_back(
      {"lines and single points bound nothing", {{"make faces of them, if they are walls", {}}},
        std::to_string(counts.loose) + " are left out"});
  }
  if (counts.flat > 0)
  {
    notes.push_back({"curved cells are cut off", {{"divide them finer first", {}}},
      std::to_string(counts.flat) + " are farther than a thousandth of the mesh's diagonal from "
                                    "their triangles"});
  }
  return notes;
}

void countLoose(vtkPointSet* mesh, CellCounts& counts)
{
  if (auto* polyData = vtkPolyData::SafeDownCast(mesh))
  {
    counts.loose +=
      static_cast<std::size_t>(polyData->GetNumberOfLines() + polyData->GetNumberOfVerts());
    return;
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(mesh);
  for (vtkIdType cell = 0; grid && cell < grid->GetNumberOfCells(); ++cell)
  {
    const int dimension = dimensionOf(grid->GetCellType(cell));
    counts.loose += dimension == 0 || dimension == 1 ? 1 : 0;
  }
}

bool isGhostCell(vtkUnsignedCharArray* flags, vtkIdType cell)
{
  constexpr int ghost = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL |
                        vtkDataSetAttributes::REFINEDCELL;
  return flags && cell < flags->GetNumberOfTuples() && (flags->GetValue(cell) & ghost) != 0;
}

vtkSmartPointer<vtkPointSet> ownCellsOf(
  vtkPointSet* mesh, bool takesFaces, const std::string& name, CellCounts& counts)
{
  vtkUnsignedCharArray* flags = mesh->GetCellGhostArray();
  const int unwanted = !isMixed(mesh) ? -1 : takesFaces ? 3 : 2;
  if (!flags && unwanted < 0)
  {
    return mesh;
  }
  const vtkIdType cells = mesh->GetNumberOfCells();
  vtkNew<vtkIdList> own;
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    if (isGhostCell(flags, cell))
    {
      continue;
    }
    if (unwanted > 0 && dimensionOf(mesh->GetCellType(cell)) == unwanted)
    {
      ++counts.leftOut;
      continue;
    }
    own->InsertNextId(cell);
  }
  if (own->GetNumberOfIds() == cells)
  {
    return mesh;
  }
  checkCells(mesh, name);
  checkArrays(mesh, name);
  vtkNew<vtkExtractCells> extract;
  extract->SetInputData(mesh);
  extract->SetCellList(own);
  extract->Update();
  if (!vtkPolyData::SafeDownCast(mesh))
  {
    return extract->GetOutput();
  }
  // The cells of polydata stay polydata.
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputConnection(extract->GetOutputPort());
  surface->Update();
  return surface->GetOutput();
}

vtkSmartPointer<vtkPolyData> outerSurfaceOf(vtkPointSet* mesh, bool keepsPoints, CellCounts& counts)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(mesh);
  const bool isCurved = grid && hasCurvedCells(grid);
  vtkSmartPointer<vtkPointSet> cells = withNumbers(mesh);
  if (isCurved)
  {
    cells = straightened(grid);
  }
  vtkSmartPointer<vtkPolyData> surface = straightSurfaceOf(cells);
  counts.turned += turnOutward(cells, surface);
  surface = withoutSeams(surface, cells);
  if (isCurved)
  {
    std::size_t flat = 0;
    surface = dividedSurface(grid, OuterPolygons(surface), keepsPoints, flat);
    counts.flat += flat;
    return surface;
  }
  surface->GetCellData()->RemoveArray("vtkOriginalCellIds");
  surface->GetPointData()->RemoveArray("vtkOriginalPointIds");
  return surface;
}

} // namespace winding
