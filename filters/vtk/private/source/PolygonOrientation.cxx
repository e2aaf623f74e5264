// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/PolygonOrientation.h"

#include "base/Views.h"
#include "private/source/CellChecks.h"
#include "private/source/FlatTriangles.h"
#include "private/source/InputViews.h"
#include "private/source/OuterSurface.h"
#include "private/source/SourceParts.h"
#include "source/Sanitize.h"
#include "source/Surface.h"
#include "surface/Orientation.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace winding
{

namespace
{

vtkSmartPointer<vtkPolyData> withCells(
  vtkPolyData* leaf, vtkCellArray* polygons, vtkCellArray* strips)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(leaf->GetPoints());
  result->SetVerts(leaf->GetVerts());
  result->SetLines(leaf->GetLines());
  result->SetPolys(polygons);
  result->SetStrips(strips);
  result->GetPointData()->ShallowCopy(leaf->GetPointData());
  result->GetCellData()->ShallowCopy(leaf->GetCellData());
  result->GetFieldData()->ShallowCopy(leaf->GetFieldData());
  return result;
}

/// The leaf itself if there are none.
vtkSmartPointer<vtkPolyData> withStripsAsTriangles(vtkPolyData* leaf)
{
  if (leaf->GetNumberOfStrips() == 0)
  {
    return leaf;
  }
  checkArrays(leaf, "the source");
  vtkNew<vtkCellArray> polygons;
  polygons->DeepCopy(leaf->GetPolys());
  const vtkIdType before = leaf->GetNumberOfCells() - leaf->GetNumberOfStrips();
  vtkNew<vtkCellData> data;
  data->CopyAllocate(leaf->GetCellData());
  for (vtkIdType cell = 0; cell < before; ++cell)
  {
    data->CopyData(leaf->GetCellData(), cell, cell);
  }
  vtkIdType size;
  const vtkIdType* ids;
  vtkNew<vtkCellArray> strip;
  for (vtkIdType i = 0; i < leaf->GetNumberOfStrips(); ++i)
  {
    leaf->GetStrips()->GetCellAtId(i, size, ids);
    strip->Reset();
    strip->InsertNextCell(size, ids);
    const std::vector<std::int64_t> triangles = trianglesOfStrips(strip);
    for (std::size_t corner = 0; corner < triangles.size(); corner += 3)
    {
      polygons->InsertNextCell(
        {static_cast<vtkIdType>(triangles[corner]), static_cast<vtkIdType>(triangles[corner + 1]),
          static_cast<vtkIdType>(triangles[corner + 2])});
      data->CopyData(leaf->GetCellData(), before + i,
        leaf->GetNumberOfVerts() + leaf->GetNumberOfLines() + polygons->GetNumberOfCells() - 1);
    }
  }
  auto result = withCells(leaf, polygons, vtkSmartPointer<vtkCellArray>::New());
  result->GetCellData()->ShallowCopy(data);
  return result;
}

/// The polygons of a leaf that are its own, and their numbers.
struct OwnPolygons
{
  vtkSmartPointer<vtkPolyData> surface;
  std::vector<vtkIdType> numbers;
};

OwnPolygons ownPolygonsOf(vtkPolyData* leaf)
{
  vtkUnsignedCharArray* flags = leaf->GetCellGhostArray();
  const vtkIdType before = leaf->GetNumberOfVerts() + leaf->GetNumberOfLines();
  OwnPolygons own;
  vtkNew<vtkCellArray> polygons;
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType i = 0; i < leaf->GetNumberOfPolys(); ++i)
  {
    if (!isGhostCell(flags, before + i))
    {
      leaf->GetPolys()->GetCellAtId(i, size, ids);
      polygons->InsertNextCell(size, ids);
      own.numbers.push_back(i);
    }
  }
  own.surface = vtkSmartPointer<vtkPolyData>::New();
  own.surface->SetPoints(leaf->GetPoints());
  own.surface->SetPolys(polygons);
  return own;
}

/// The polygons of a leaf that change, by ascending numbers.
struct PolygonChanges
{
  std::vector<vtkIdType> turned, leftOut;

  bool areNone() const { return turned.empty() && leftOut.empty(); }
};

/// Moves on to the next of `numbers` if `next` is at `number`. Returns whether it is.
bool pass(std::vector<vtkIdType>::const_iterator& next, const std::vector<vtkIdType>& numbers,
  vtkIdType number)
{
  const bool isAt = next != numbers.end() && *next == number;
  next += isAt;
  return isAt;
}

vtkSmartPointer<vtkPolyData> withChanges(vtkPolyData* leaf, const PolygonChanges& changes)
{
  vtkNew<vtkCellArray> polygons;
  auto turned = changes.turned.begin(), leftOut = changes.leftOut.begin();
  std::vector<vtkIdType> reversed;
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType i = 0; i < leaf->GetNumberOfPolys(); ++i)
  {
    if (pass(leftOut, changes.leftOut, i))
    {
      continue;
    }
    leaf->GetPolys()->GetCellAtId(i, size, ids);
    if (pass(turned, changes.turned, i))
    {
      // The polygon keeps its first point, so that the fan has the same triangles.
      reversed.assign(ids, ids + size);
      std::reverse(reversed.begin() + 1, reversed.end());
      ids = reversed.data();
    }
    polygons->InsertNextCell(size, ids);
  }
  const auto result = withCells(leaf, polygons, leaf->GetStrips());
  if (!changes.leftOut.empty())
  {
    vtkNew<vtkCellData> data;
    data->CopyAllocate(leaf->GetCellData());
    const vtkIdType before = leaf->GetNumberOfVerts() + leaf->GetNumberOfLines();
    leftOut = changes.leftOut.begin();
    for (vtkIdType cell = 0, kept = 0; cell < leaf->GetNumberOfCells(); ++cell)
    {
      if (!pass(leftOut, changes.leftOut, cell - before))
      {
        data->CopyData(leaf->GetCellData(), cell, kept++);
      }
    }
    result->GetCellData()->ShallowCopy(data);
  }
  return result;
}

/// The polygons that the triangles of a surface come from, in several leaves.
struct PolygonTriangles
{
  struct Origin
  {
    std::size_t leaf;
    vtkIdType polygon;
  };

  std::vector<Origin> origins; ///< by triangle

  /// One view for each leaf that has polygons, in their order.
  void add(const TrianglesView& view, std::size_t leaf, const OwnPolygons& own)
  {
    std::size_t triangle = 0;
    for (std::size_t i = 0; i < own.numbers.size(); ++i)
    {
      const vtkIdType size = own.surface->GetPolys()->GetCellSize(static_cast<vtkIdType>(i));
      for (vtkIdType corner = 2; corner < size; ++corner, ++triangle)
      {
        if (isUsable(view, triangle))
        {
          origins.push_back({leaf, own.numbers[i]});
        }
      }
    }
  }
};

} // namespace

OrientedPolygons orientPolygons(
  const std::vector<vtkSmartPointer<vtkPolyData>>& leaves, double weldTolerance, Executor& executor)
{
  std::vector<vtkSmartPointer<vtkPolyData>> bases, surfaces;
  std::vector<std::pair<std::size_t, OwnPolygons>> owned;
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    bases.push_back(withStripsAsTriangles(leaves[i]));
    OwnPolygons own = ownPolygonsOf(bases.back());
    if (!own.numbers.empty() && bases.back()->GetNumberOfPoints() > 0)
    {
      surfaces.push_back(own.surface);
      owned.emplace_back(i, std::move(own));
    }
  }
  InputOptions options;
  options.weldTolerance = weldTolerance;
  InputViews views(asBlocks(surfaces), options, &executor);
  const std::vector<TrianglesView> triangles = views.triangles();
  PolygonTriangles polygons;
  for (std::size_t i = 0; i < owned.size(); ++i)
  {
    polygons.add(triangles[i], owned[i].first, owned[i].second);
  }
  const Surface surface = sanitize(triangles, executor);
  const Orientation orientation = orient(surface, polygonPartsOf(triangles), executor);

  std::vector<PolygonChanges> changes(leaves.size());
  OrientedPolygons result;
  for (std::size_t i = 0; i < polygons.origins.size(); ++i)
  {
    const auto& [leaf, polygon] = polygons.origins[i];
    const auto note = [number = polygon](std::vector<vtkIdType>& numbers)
    {
      const bool isNew = numbers.empty() || numbers.back() != number;
      if (isNew)
      {
        numbers.push_back(number);
      }
      return isNew;
    };
    if (!orientation.isLeftOut.empty() && orientation.isLeftOut[i])
    {
      result.leftOut += note(changes[leaf].leftOut);
    }
    else if (orientation.isTurned[i])
    {
      note(changes[leaf].turned);
    }
  }
  result.triangles = orientation.triangles;
  result.components = orientation.components;
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    result.leaves.push_back(changes[i].areNone() ? leaves[i] : withChanges(bases[i], changes[i]));
  }
  return result;
}

} // namespace winding
