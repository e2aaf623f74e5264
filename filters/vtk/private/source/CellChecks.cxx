// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/CellChecks.h"

#include "base/Refusal.h"
#include "pipeline/VtkVersions.h"
#include "private/source/CellTypes.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
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
  throw Refusal("mend the data set: " + name + " " + fault);
}

[[noreturn]] void refuseCell(const std::string& name, vtkIdType cell, const std::string& fault)
{
  refuse("cell " + std::to_string(cell) + " of " + name, fault);
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

void checkOffsets(vtkCellArray* cells, const std::string& name)
{
  if (cells && !cells->IsValid())
  {
    refuse(name, "has cells whose offsets lead out of their list of ids");
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

void checkTypes(vtkUnstructuredGrid* grid, const std::string& name)
{
  vtkDataArray* types = cellTypesOf(grid);
  const vtkIdType cells = grid->GetNumberOfCells();
  if (cells > 0 && (!types || types->GetNumberOfTuples() < cells))
  {
    refuse(name, "has " + std::to_string(cells) + " cells but types for " +
                   std::to_string(types ? types->GetNumberOfTuples() : 0));
  }
}

void checkIds(const vtkIdType* first, const vtkIdType* last, vtkIdType cell, vtkIdType points,
  const std::string& name)
{
  const vtkIdType* const bad =
    std::find_if(first, last, [points](vtkIdType id) { return id < 0 || id >= points; });
  if (bad != last)
  {
    refuseCell(
      name, cell, "refers to point " + std::to_string(*bad) + " of " + std::to_string(points));
  }
}

/// vtkPolyData gives no cell at all where one of them has too few points for its kind, which
/// matters only where cells are used.
void checkPolyDataCells(vtkPolyData* polyData, bool areUsed, const std::string& name)
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
        refuseCell(name, cell,
          "has " + std::to_string(size) + " points and needs " + std::to_string(fewest));
      }
      checkIds(ids, ids + size, cell, polyData->GetNumberOfPoints(), name);
    }
  }
}

/// Checks that the faces of a polyhedron have no other points than it has itself.
void checkFaces(vtkUnstructuredGrid* grid, vtkIdType cell, vtkIdList* ids, const std::string& name)
{
  std::vector<vtkIdType> own(ids->begin(), ids->end());
  std::sort(own.begin(), own.end());
  vtkNew<vtkIdList> stream; // of the number of faces, then of each face its size and its ids
  grid->GetFaceStream(cell, stream);
  vtkIdType at = 1;
  while (at < stream->GetNumberOfIds())
  {
    const vtkIdType end = at + 1 + stream->GetId(at);
    for (++at; at < end; ++at)
    {
      if (!std::binary_search(own.begin(), own.end(), stream->GetId(at)))
      {
        refuseCell(name, cell,
          "is a polyhedron with a face at point " + std::to_string(stream->GetId(at)) +
            ", which is none of its points");
      }
    }
  }
}

/// The degrees of a Lagrange or Bézier cell along its axes; null where the grid has none.
const double* degreesOf(vtkUnstructuredGrid* grid, vtkIdType cell, double* degrees)
{
  vtkDataArray* all = grid->GetCellData()->GetHigherOrderDegrees();
  if (!all || all->GetNumberOfComponents() != 3)
  {
    return nullptr;
  }
  all->GetTuple(cell, degrees);
  return degrees;
}

void checkGridCell(
  vtkUnstructuredGrid* grid, vtkIdType cell, vtkIdList* ids, const std::string& name)
{
  const int type = grid->GetCellType(cell);
  const std::string ofCell = "cell " + std::to_string(cell) + " of " + name;
  if (dimensionOf(type) < 0)
  {
    throw Refusal(Message(ofCell + " has unknown type " + std::to_string(type),
      {{"use a VTK that knows it", {}}, {"leave these cells out", {}}}));
  }
  if (!hasFacesOfItsType(grid, cell))
  {
    if (type == VTK_POLYHEDRON)
    {
      throw Refusal(Message(ofCell + " is a polyhedron without faces",
        {{"read it with a newer VTK, if one has written it", {}}, {"give it faces", {}}}));
    }
    refuseCell(name, cell, "has faces that are not there, or none where it needs some");
  }
  double degrees[3];
  if (type == VTK_POLYHEDRON)
  {
    checkFaces(grid, cell, ids, name);
  }
  else if (!canHavePoints(type, ids->GetNumberOfIds(), degreesOf(grid, cell, degrees)))
  {
    refuseCell(name, cell,
      "has " + std::to_string(ids->GetNumberOfIds()) + " points, which a cell of type " +
        std::to_string(type) + " cannot have");
  }
}

} // namespace

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
  if (auto* polyData = vtkPolyData::SafeDownCast(data))
  {
    for (vtkCellArray* cells :
      {polyData->GetVerts(), polyData->GetLines(), polyData->GetPolys(), polyData->GetStrips()})
    {
      checkOffsets(cells, name);
    }
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    for (vtkCellArray* cells : {grid->GetCells(), faceListsOf(grid)[0], faceListsOf(grid)[1]})
    {
      checkOffsets(cells, name);
    }
    checkTypes(grid, name);
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
  if (auto* polyData = vtkPolyData::SafeDownCast(data))
  {
    checkPolyDataCells(polyData, areUsed, name);
    return;
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    data->GetCellPoints(cell, ids);
    checkIds(ids->begin(), ids->end(), cell, data->GetNumberOfPoints(), name);
    if (grid)
    {
      checkGridCell(grid, cell, ids, name);
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
