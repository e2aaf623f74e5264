// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/RegionCells.h"

#include "private/source/FlatTriangles.h"
#include "private/source/InputViews.h"
#include "source/Sanitize.h"
#include "surface/OpenParts.h"
#include "surface/SolidParts.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkExtractCells.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace winding
{

namespace
{

/// Calls visit(cell, points, size) for each polygon and strip, by its id as a cell.
template <class Visit> void forEachFace(vtkPolyData* surface, const Visit& visit)
{
  vtkIdType cell = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  for (vtkCellArray* faces : {surface->GetPolys(), surface->GetStrips()})
  {
    vtkIdType size;
    const vtkIdType* points;
    for (vtkIdType i = 0; i < faces->GetNumberOfCells(); ++i, ++cell)
    {
      faces->GetCellAtId(i, size, points);
      visit(cell, points, size);
    }
  }
}

/// Adds faces to another surface, whose points are these faces'.
class FaceCopier
{
public:
  FaceCopier(vtkPolyData* from, std::vector<vtkIdType>& newIds)
    : newIds_(newIds)
    , count_(from->GetNumberOfPoints())
  {
    newIds_.resize(static_cast<std::size_t>(count_), -1);
  }

  ~FaceCopier()
  {
    for (vtkIdType i = 0; i < points_->GetNumberOfIds(); ++i)
    {
      newIds_[static_cast<std::size_t>(points_->GetId(i))] = -1;
    }
  }

  FaceCopier(const FaceCopier&) = delete;
  FaceCopier& operator=(const FaceCopier&) = delete;

  void add(vtkCellArray* from, vtkIdType cell, vtkCellArray* to)
  {
    vtkIdType size;
    const vtkIdType* points;
    from->GetCellAtId(cell, size, points);
    to->InsertNextCell(static_cast<int>(size));
    for (vtkIdType i = 0; i < size; ++i)
    {
      to->InsertCellPoint(this->newId(points[i]));
    }
  }

  /// The points of all faces that were added.
  vtkIdList* points() const { return points_; }

private:
  /// −1 for a point that does not exist.
  vtkIdType newId(vtkIdType point)
  {
    if (point < 0 || point >= count_)
    {
      return -1;
    }
    vtkIdType& id = newIds_[static_cast<std::size_t>(point)];
    if (id < 0)
    {
      id = points_->InsertNextId(point);
    }
    return id;
  }

  std::vector<vtkIdType>& newIds_;
  vtkIdType count_;
  vtkNew<vtkIdList> points_;
};

/// Copies the arrays of some points of one data set to another, which has these points alone.
void copyPointData(vtkPointSet* from, vtkIdList* points, vtkPointSet* to)
{
  vtkPointData* const arrays = to->GetPointData();
  arrays->CopyAllocate(from->GetPointData(), points->GetNumberOfIds());
  for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
  {
    arrays->CopyData(from->GetPointData(), points->GetId(i), i);
  }
}

vtkSmartPointer<vtkPolyData> facesOfCells(vtkPolyData* surface, const std::vector<vtkIdType>& cells,
  std::vector<vtkIdType>& newIds, bool keepsPointData)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  if (cells.empty())
  {
    return result;
  }
  const vtkIdType before = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  const vtkIdType polygons = surface->GetNumberOfPolys();
  vtkNew<vtkCellArray> polys, strips;
  FaceCopier copier(surface, newIds);
  for (const vtkIdType cell : cells)
  {
    const vtkIdType face = cell - before;
    if (face < polygons)
    {
      copier.add(surface->GetPolys(), face, polys);
    }
    else
    {
      copier.add(surface->GetStrips(), face - polygons, strips);
    }
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(surface->GetPoints()->GetDataType());
  points->SetNumberOfPoints(copier.points()->GetNumberOfIds());
  surface->GetPoints()->GetData()->GetTuples(copier.points(), points->GetData());
  result->SetPoints(points);
  result->SetPolys(polys);
  result->SetStrips(strips);
  if (keepsPointData)
  {
    copyPointData(surface, copier.points(), result);
  }
  return result;
}

} // namespace

std::pair<vtkIdType, vtkIdType> facesOf(vtkPointSet* data)
{
  auto* surface = vtkPolyData::SafeDownCast(data);
  return {surface ? surface->GetNumberOfVerts() + surface->GetNumberOfLines() : 0,
    data->GetNumberOfCells()};
}

SolidCells solidCellsOf(
  vtkPolyData* surface, bool ignoresOpenParts, double weldTolerance, Executor& executor)
{
  InputOptions options;
  options.weldTolerance = weldTolerance;
  InputViews views(surface, options, &executor);
  const std::vector<TrianglesView> triangles = views.triangles();
  // The faces of the triangles that a surface keeps. Views have polygons first, then strips.
  SolidCells result;
  std::vector<vtkIdType> faces;
  PolygonParts parts;
  std::size_t view = 0, triangle = 0;
  forEachFace(surface,
    [&](vtkIdType cell, const vtkIdType*, vtkIdType size)
    {
      bool isFirst = true;
      for (vtkIdType corner = 2; corner < size; ++corner, ++triangle)
      {
        while (triangle == triangles[view].triangles.size())
        {
          ++view;
          triangle = 0;
        }
        if (isUsable(triangles[view], triangle))
        {
          faces.push_back(cell);
          parts.push_back(!isFirst);
          isFirst = false;
        }
      }
      if (isFirst)
      {
        result.unusable.push_back(cell);
      }
    });
  const Surface clean = sanitize(triangles, executor);
  const SolidParts solids = solidPartsOf(clean, parts, executor);
  const OpenParts open = openPartsInside(clean, edgesOf(clean, executor), executor);
  const auto isOpen = [&open](std::size_t number)
  {
    return !open.isInside.empty() && open.isInside[number];
  };
  std::vector<std::vector<vtkIdType>> cells(solids.count);
  std::vector<char> isOpenPart(solids.count, 1);
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const auto solid = static_cast<std::size_t>(solids.ofTriangle[i]);
    isOpenPart[solid] &= static_cast<char>(isOpen(i));
    if (!parts[i] && !(ignoresOpenParts && isOpen(i)))
    {
      cells[solid].push_back(faces[i]);
    }
  }
  for (std::size_t solid = 0; solid < solids.count; ++solid)
  {
    if (!cells[solid].empty())
    {
      result.cells.push_back(std::move(cells[solid]));
      result.isOpenPart.push_back(isOpenPart[solid]);
    }
  }
  return result;
}

vtkSmartPointer<vtkPointSet> cellsOf(vtkPointSet* data, const std::vector<vtkIdType>& cells,
  std::vector<vtkIdType>& newIds, bool keepsPointData)
{
  if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    return facesOfCells(surface, cells, newIds, keepsPointData);
  }
  vtkNew<vtkIdList> ids;
  for (const vtkIdType cell : cells)
  {
    ids->InsertNextId(cell);
  }
  vtkNew<vtkExtractCells> extract;
  extract->SetInputData(data);
  extract->SetCellList(ids);
  extract->Update();
  return extract->GetOutput();
}

} // namespace winding
