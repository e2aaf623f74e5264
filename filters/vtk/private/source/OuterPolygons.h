// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <vector>

namespace winding
{

/// The polygons of an outer surface that VTK has made with the numbers of its cells and points.
class OuterPolygons
{
public:
  explicit OuterPolygons(vtkPolyData* surface)
    : polygons_(surface->GetPolys())
    , before_(surface->GetNumberOfVerts() + surface->GetNumberOfLines())
    , cells_(idsIn(surface->GetCellData(), "vtkOriginalCellIds"))
    , points_(idsIn(surface->GetPointData(), "vtkOriginalPointIds"))
  {
  }

  /// Returns the number of polygons whose cells are known: of all, or of none.
  vtkIdType count() const { return cells_ && points_ ? polygons_->GetNumberOfCells() : 0; }

  /// Returns the cell of the mesh that a polygon is a face of.
  vtkIdType owner(vtkIdType polygon) const { return cells_->GetValue(before_ + polygon); }

  /// Returns the points of the mesh that a polygon has.
  std::vector<vtkIdType> points(vtkIdType polygon) const
  {
    vtkIdType size;
    const vtkIdType* ids;
    polygons_->GetCellAtId(polygon, size, ids);
    std::vector<vtkIdType> points(ids, ids + size);
    std::transform(points.begin(), points.end(), points.begin(),
      [this](vtkIdType id) { return points_->GetValue(id); });
    return points;
  }

private:
  static vtkIdTypeArray* idsIn(vtkDataSetAttributes* arrays, const char* name)
  {
    return vtkIdTypeArray::SafeDownCast(arrays->GetArray(name));
  }

  vtkCellArray* polygons_;
  vtkIdType before_;
  vtkIdTypeArray* cells_;
  vtkIdTypeArray* points_;
};

} // namespace winding
