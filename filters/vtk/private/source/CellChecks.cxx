// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/CellChecks.h"

#include "mesh/CellChecks.h"
#include "mesh/CellTypes.h"
#include "pipeline/VtkVersions.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace winding
{

namespace
{

[[noreturn]] void refuse(const std::string& name, const std::string& fault)
{
  CellChecks(name, 0).refuse(fault);
}

/// Returns whether the VTK at hand has cells of a type.
bool isKnownToVtk(int type)
{
  return vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type)) != nullptr;
}

void checkLengths(
  vtkDataSetAttributes* arrays, vtkIdType count, const std::string& of, const std::string& name)
{
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(i);
    if (array->GetNumberOfTuples() < count)
    {
      refuse(name, "has an array '" + std::string(array->GetName() ? array->GetName() : "") +
                     "' with " + std::to_string(array->GetNumberOfTuples()) + " values for " +
                     std::to_string(count) + " " + of);
    }
  }
}

/// Refuses an `extent` that ends before it begins, where VTK counts points or cells of it all the
/// same. Returns its numbers of points along the axes.
std::array<double, 3> checkSizes(vtkDataSet* data, const int* extent, const std::string& name)
{
  if (data->GetNumberOfPoints() != 0 || data->GetNumberOfCells() != 0) // may be negative
  {
    checkExtent(extent, name);
  }
  std::array<double, 3> sizes; // cannot overflow, as integers could
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    sizes[axis] = std::max(0.0, 1.0 + extent[2 * axis + 1] - extent[2 * axis]);
  }
  return sizes;
}

void checkNodes(vtkStructuredGrid* grid, const std::string& name)
{
  const std::array<double, 3> sizes = checkSizes(grid, grid->GetExtent(), name);
  const vtkIdType points = grid->GetNumberOfPoints();
  if (sizes[0] * sizes[1] * sizes[2] > static_cast<double>(points))
  {
    refuse(
      name, "is a structured grid with more nodes than its " + std::to_string(points) + " points");
  }
}

void checkCoordinates(vtkRectilinearGrid* grid, const std::string& name)
{
  const std::array<double, 3> sizes = checkSizes(grid, grid->GetExtent(), name);
  vtkDataArray* const coordinates[] = {
    grid->GetXCoordinates(), grid->GetYCoordinates(), grid->GetZCoordinates()};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const vtkIdType count = coordinates[axis] ? coordinates[axis]->GetNumberOfTuples() : 0;
    if (sizes[axis] > static_cast<double>(count) && grid->GetNumberOfPoints() > 0)
    {
      refuse(name, "is a rectilinear grid with " + std::to_string(count) + " coordinates for " +
                     std::to_string(static_cast<vtkIdType>(sizes[axis])) + " points along " +
                     "xyz"[axis]);
    }
  }
}

/// vtkPolyData gives no cell at all where one of them has too few points for its kind, which
/// matters only where cells are used.
void checkPolyDataCells(vtkPolyData* polyData, bool areUsed, const CellChecks& checks)
{
  const std::pair<vtkCellArray*, vtkIdType> kinds[] = {{polyData->GetVerts(), 1},
    {polyData->GetLines(), 2}, {polyData->GetPolys(), 3}, {polyData->GetStrips(), 3}};
  vtkIdType cell = 0; // counted through all kinds, as vtkPolyData does
  for (const auto& [cells, fewest] : kinds)
  {
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i, ++cell)
    {
      vtkIdType size;
      const vtkIdType* ids;
      cells->GetCellAtId(i, size, ids);
      if (areUsed && size < fewest)
      {
        checks.refuseCell(
          cell, "has " + std::to_string(size) + " points and needs " + std::to_string(fewest));
      }
      checks.checkIds(cell, ids, ids + size);
    }
  }
}

/// The degrees of a Lagrange or Bézier cell along its axes; null where the grid has none.
const double* degreesOf(vtkUnstructuredGrid* grid, vtkIdType cell, double* degrees)
{
  vtkDataArray* all = grid->GetCellData()->GetHigherOrderDegrees();
  if (!all || all->GetNumberOfComponents() != 3 || cell >= all->GetNumberOfTuples())
  {
    return nullptr;
  }
  all->GetTuple(cell, degrees);
  return degrees;
}

void checkGridCell(
  vtkUnstructuredGrid* grid, vtkIdType cell, vtkIdList* ids, const CellChecks& checks)
{
  const int type = grid->GetCellType(cell);
  const bool isPolyhedron = type == polyhedronType;
  double degrees[3];
  checks.checkType(cell, type, ids->GetNumberOfIds(), degreesOf(grid, cell, degrees));
  std::vector<std::int64_t> faces;
  if (!hasFacesOfItsType(grid, cell))
  {
    if (!isPolyhedron)
    {
      checks.refuseCell(cell, "has faces that are not there, or none where it needs some");
    }
  }
  else if (isPolyhedron)
  {
    appendFaces(grid, cell, faces);
  }
  if (isPolyhedron)
  {
    checks.checkPolyhedron(cell, faces, {ids->begin(), ids->end()});
  }
}

} // namespace

void appendFaces(vtkUnstructuredGrid* mesh, vtkIdType cell, std::vector<std::int64_t>& ids)
{
  vtkNew<vtkIdList> faces;
  mesh->GetFaceStream(cell, faces);
  ids.insert(ids.end(), faces->begin(), faces->end());
}

void checkExtent(const int* extent, const std::string& name)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int first = extent[2 * axis], last = extent[2 * axis + 1];
    if (1.0 + last < first)
    {
      refuse(name, "has an extent that runs from " + std::to_string(first) + " to " +
                     std::to_string(last) + " along " + "xyz"[axis]);
    }
  }
}

void checkStructure(vtkDataSet* data, const std::string& name)
{
  const CellChecks checks(name, data->GetNumberOfPoints());
  if (auto* polyData = vtkPolyData::SafeDownCast(data))
  {
    for (vtkCellArray* cells :
      {polyData->GetVerts(), polyData->GetLines(), polyData->GetPolys(), polyData->GetStrips()})
    {
      checks.checkOffsets(!cells || cells->IsValid());
    }
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    for (vtkCellArray* cells : {grid->GetCells(), faceListsOf(grid)[0], faceListsOf(grid)[1]})
    {
      checks.checkOffsets(!cells || cells->IsValid());
    }
    const vtkDataArray* const types = cellTypesOf(grid);
    checks.checkTypes(grid->GetNumberOfCells(), types ? types->GetNumberOfTuples() : 0);
  }
  else if (auto* structured = vtkStructuredGrid::SafeDownCast(data))
  {
    checkNodes(structured, name);
  }
  else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data))
  {
    checkCoordinates(rectilinear, name);
  }
  else if (auto* image = vtkImageData::SafeDownCast(data))
  {
    const std::array<double, 3> sizes = checkSizes(image, image->GetExtent(), name);
    if (sizes[0] * sizes[1] * sizes[2] > static_cast<double>(VTK_ID_MAX))
    {
      refuse(name, "has more points than there are ids");
    }
  }
}

namespace
{

void checkCells(vtkDataSet* data, bool areUsed, const std::string& name)
{
  checkStructure(data, name);
  if (!vtkPointSet::SafeDownCast(data))
  {
    return; // images and the like compute their cells
  }
  const CellChecks checks(name, data->GetNumberOfPoints());
  if (auto* polyData = vtkPolyData::SafeDownCast(data))
  {
    checkPolyDataCells(polyData, areUsed, checks);
    return;
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  std::vector<char> isKnown(256, 0);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    const int type = data->GetCellType(cell);
    char& isTypeKnown = isKnown[static_cast<std::size_t>(type) % isKnown.size()];
    if (!isTypeKnown && !isKnownToVtk(type))
    {
      checks.refuseType(cell, type); // VTK has no cell to ask
    }
    isTypeKnown = 1;
    data->GetCellPoints(cell, ids);
    checks.checkIds(cell, ids->begin(), ids->end());
    if (grid)
    {
      checkGridCell(grid, cell, ids, checks);
    }
  }
}

} // namespace

void checkCells(vtkDataSet* data, const std::string& name)
{
  checkCells(data, true, name);
}

void checkUnusedCells(vtkDataSet* data, const std::string& name)
{
  checkCells(data, false, name);
}

void checkArrays(vtkDataSet* data, const std::string& name)
{
  checkLengths(data->GetPointData(), data->GetNumberOfPoints(), "points", name);
  checkLengths(data->GetCellData(), data->GetNumberOfCells(), "cells", name);
}

} // namespace winding
