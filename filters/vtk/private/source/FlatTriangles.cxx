// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/FlatTriangles.h"

#include "vtkCellArray.h"

namespace winding
{

namespace
{

/// A strip: every other triangle is turned round.
void appendStrip(vtkIdType size, const vtkIdType* ids, std::vector<std::int64_t>& triangles)
{
  for (vtkIdType i = 2; i < size; ++i)
  {
    const bool turned = i % 2 == 1;
    triangles.insert(
      triangles.end(), {ids[i - 2], ids[turned ? i : i - 1], ids[turned ? i - 1 : i]});
  }
}

/// Calls append(size, ids) for each cell.
template <class Append> void forEachCell(vtkCellArray* cells, const Append& append)
{
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, size, ids);
    append(size, ids);
  }
}

} // namespace

FlatTriangles trianglesOfPolygons(vtkCellArray* polygons)
{
  FlatTriangles triangles;
  const auto corners = static_cast<std::size_t>(polygons->GetNumberOfConnectivityIds());
  triangles.ids.reserve(3 * corners);
  triangles.isContinued.reserve(corners);
  forEachCell(polygons,
    [&triangles](vtkIdType size, const vtkIdType* ids)
    {
      for (vtkIdType i = 2; i < size; ++i)
      {
        triangles.ids.insert(triangles.ids.end(), {ids[0], ids[i - 1], ids[i]});
        triangles.isContinued.push_back(i > 2);
      }
    });
  return triangles;
}

std::vector<std::int64_t> trianglesOfStrips(vtkCellArray* strips)
{
  std::vector<std::int64_t> triangles;
  triangles.reserve(3 * static_cast<std::size_t>(strips->GetNumberOfConnectivityIds()));
  forEachCell(strips,
    [&triangles](vtkIdType size, const vtkIdType* ids) { appendStrip(size, ids, triangles); });
  return triangles;
}

} // namespace winding
