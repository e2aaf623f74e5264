// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/CellTypes.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>

namespace winding
{

namespace
{

struct Kind
{
  int dimension = -1;
  vtkIdType points = 0; ///< the fewest points of a cell; 0 where it varies
  int straightType = -1;
};

using Kinds = std::array<Kind, 256>;

int straightTypeOf(vtkCell* cell)
{
  if (cell->IsLinear())
  {
    return cell->GetCellType();
  }
  if (cell->GetCellType() == VTK_QUADRATIC_POLYGON)
  {
    return VTK_POLYGON;
  }
  switch (cell->GetCellDimension())
  {
  case 1:
    return VTK_LINE;
  case 2:
    return cell->GetNumberOfEdges() == 3 ? VTK_TRIANGLE : VTK_QUAD;
  default:
    break;
  }
  switch (cell->GetNumberOfEdges())
  {
  case 6:
    return VTK_TETRA;
  case 8:
    return VTK_PYRAMID;
  case 9:
    return VTK_WEDGE;
  default:
    return VTK_HEXAHEDRON;
  }
}

Kinds makeKinds()
{
  Kinds kinds;
  for (std::size_t type = 0; type < kinds.size(); ++type)
  {
    const auto cell =
      vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(static_cast<int>(type)));
    if (cell)
    {
      kinds[type] = {cell->GetCellDimension(), cell->GetNumberOfPoints(), straightTypeOf(cell)};
    }
  }
  return kinds;
}

const Kind& kindOf(int cellType)
{
  static const Kinds kinds = makeKinds();
  static const Kind unknown;
  return cellType >= 0 && cellType < static_cast<int>(kinds.size())
           ? kinds[static_cast<std::size_t>(cellType)]
           : unknown;
}

/// The points of a cell of given degrees along its axes; 0 for types of one number of points.
double pointsOfDegrees(int cellType, double a, double b, double c)
{
  switch (cellType)
  {
  case VTK_LAGRANGE_CURVE:
  case VTK_BEZIER_CURVE:
    return a + 1;
  case VTK_LAGRANGE_TRIANGLE:
  case VTK_BEZIER_TRIANGLE:
    return (a + 1) * (a + 2) / 2;
  case VTK_LAGRANGE_QUADRILATERAL:
  case VTK_BEZIER_QUADRILATERAL:
    return (a + 1) * (b + 1);
  case VTK_LAGRANGE_TETRAHEDRON:
  case VTK_BEZIER_TETRAHEDRON:
    return (a + 1) * (a + 2) * (a + 3) / 6;
  case VTK_LAGRANGE_HEXAHEDRON:
  case VTK_BEZIER_HEXAHEDRON:
    return (a + 1) * (b + 1) * (c + 1);
  case VTK_LAGRANGE_WEDGE:
  case VTK_BEZIER_WEDGE:
    return (a + 1) * (a + 2) / 2 * (c + 1);
  default:
    return 0;
  }
}

/// VTK's triangles, tetrahedra and wedges of degree 2 may have a point more in each middle.
bool isSerendipity(int cellType, vtkIdType points)
{
  const bool isTriangle = cellType == VTK_LAGRANGE_TRIANGLE || cellType == VTK_BEZIER_TRIANGLE;
  const bool isTetra = cellType == VTK_LAGRANGE_TETRAHEDRON || cellType == VTK_BEZIER_TETRAHEDRON;
  const bool isWedge = cellType == VTK_LAGRANGE_WEDGE || cellType == VTK_BEZIER_WEDGE;
  return (isTriangle && points == 7) || (isTetra && points == 15) || (isWedge && points == 21);
}

} // namespace

int dimensionOf(int cellType)
{
  return kindOf(cellType).dimension;
}

int straightTypeOf(int cellType)
{
  const int type = kindOf(cellType).straightType;
  return type < 0 ? cellType : type;
}

vtkIdType cornersOf(vtkCell* face)
{
  return face->IsLinear() ? face->GetNumberOfPoints() : face->GetNumberOfEdges();
}

vtkIdType fewestPointsOf(int cellType)
{
  return kindOf(cellType).points;
}

bool canHavePoints(int cellType, vtkIdType points, const double* degrees)
{
  if (pointsOfDegrees(cellType, 1, 1, 1) == 0)
  {
    return points >= kindOf(cellType).points;
  }
  if (isSerendipity(cellType, points))
  {
    return true;
  }
  const auto wanted = static_cast<double>(points);
  if (degrees)
  {
    return std::all_of(degrees, degrees + 3, [](double degree) { return degree >= 1; }) &&
           pointsOfDegrees(cellType, degrees[0], degrees[1], degrees[2]) == wanted;
  }
  double degree = 1;
  while (pointsOfDegrees(cellType, degree, degree, degree) < wanted)
  {
    ++degree;
  }
  return pointsOfDegrees(cellType, degree, degree, degree) == wanted;
}

} // namespace winding
