#include "private/source/FlatTriangles.h"

#include "vtkCellArray.h"

namespace winding
{

namespace
{

void appendFan(vtkIdType size, const vtkIdType* ids, std::vector<std::int64_t>& triangles)
{
  for (vtkIdType i = 2; i < size; ++i)
  {
    triangles.insert(triangles.end(), {ids[0], ids[i - 1], ids[i]});
  }
}

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

template <class Append> std::vector<std::int64_t> flatten(vtkCellArray* cells, const Append& append)
{
  std::vector<std::int64_t> triangles;
  triangles.reserve(3 * static_cast<std::size_t>(cells->GetNumberOfConnectivityIds()));
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, size, ids);
    append(size, ids, triangles);
  }
  return triangles;
}

} // namespace

std::vector<std::int64_t> trianglesOfPolygons(vtkCellArray* polygons)
{
  return flatten(polygons, appendFan);
}

std::vector<std::int64_t> trianglesOfStrips(vtkCellArray* strips)
{
  return flatten(strips, appendStrip);
}

} // namespace winding
