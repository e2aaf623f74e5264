// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/CellTypes.h"

#include <algorithm>
#include <array>

namespace winding
{

namespace
{

enum Type
{
  line = 3,
  triangle = 5,
  polygon = 7,
  quad = 9,
  tetra,
  voxel,
  hexahedron,
  wedge,
  pyramid,
  pentagonalPrism,
  hexagonalPrism
};

struct Kind
{
  int type;
  int dimension;
  int points;       ///< the fewest of a cell; 0 where it varies
  int straightType; ///< 0 for the type itself
};

constexpr Kind kinds[] = {{0, 0, 0, 0}, {1, 0, 1, 0}, {2, 0, 0, 0}, {line, 1, 2, 0}, {4, 1, 0, 0},
  {triangle, 2, 3, 0}, {6, 2, 0, 0}, {polygon, 2, 0, 0}, {8, 2, 4, 0}, {quad, 2, 4, 0},
  {tetra, 3, 4, 0}, {voxel, 3, 8, 0}, {hexahedron, 3, 8, 0}, {wedge, 3, 6, 0}, {pyramid, 3, 5, 0},
  {pentagonalPrism, 3, 10, 0}, {hexagonalPrism, 3, 12, 0},
  // quadratic and cubic cells
  {21, 1, 3, line}, {22, 2, 6, triangle}, {23, 2, 8, quad}, {24, 3, 10, tetra},
  {25, 3, 20, hexahedron}, {26, 3, 15, wedge}, {27, 3, 13, pyramid}, {28, 2, 9, quad},
  {29, 3, 27, hexahedron}, {30, 2, 6, quad}, {31, 3, 12, wedge}, {32, 3, 18, wedge},
  {33, 3, 24, hexahedron}, {34, 2, 7, triangle}, {35, 1, 4, line},
  {quadraticPolygonType, 2, 0, polygon}, {37, 3, 19, pyramid},
  // sets of points, and polyhedra
  {41, 3, 0, 0}, {polyhedronType, 3, 0, 0},
  // Lagrange cells
  {68, 1, 2, line}, {69, 2, 3, triangle}, {70, 2, 4, quad}, {71, 3, 4, tetra},
  {72, 3, 8, hexahedron}, {73, 3, 6, wedge},
  // Bézier cells
  {75, 1, 2, line}, {76, 2, 3, triangle}, {77, 2, 4, quad}, {78, 3, 4, tetra},
  {79, 3, 8, hexahedron}, {80, 3, 6, wedge}};

const Kind& kindOf(int cellType)
{
  static const auto byType = []
  {
    std::array<Kind, 256> all;
    all.fill({-1, -1, 0, 0});
    for (const Kind& kind : kinds)
    {
      all[static_cast<std::size_t>(kind.type)] = kind;
    }
    return all;
  }();
  return byType[cellType >= 0 && cellType < 256 ? static_cast<std::size_t>(cellType) : 255];
}

/// Returns the points of a cell of given degrees along its axes; 0 for types of one number of
/// points.
double pointsOfDegrees(int cellType, double a, double b, double c)
{
  if (cellType < 68)
  {
    return 0;
  }
  switch (straightTypeOf(cellType))
  {
  case line:
    return a + 1;
  case triangle:
    return (a + 1) * (a + 2) / 2;
  case quad:
    return (a + 1) * (b + 1);
  case tetra:
    return (a + 1) * (a + 2) * (a + 3) / 6;
  case hexahedron:
    return (a + 1) * (b + 1) * (c + 1);
  case wedge:
    return (a + 1) * (a + 2) / 2 * (c + 1);
  default:
    return 0;
  }
}

/// Returns whether a Lagrange or Bézier cell of degree 2 has a point more in each middle.
bool isSerendipity(int cellType, std::int64_t points)
{
  const int type = straightTypeOf(cellType);
  return (type == triangle && points == 7) || (type == tetra && points == 15) ||
         (type == wedge && points == 21);
}

} // namespace

int dimensionOf(int cellType)
{
  return kindOf(cellType).dimension;
}

int straightTypeOf(int cellType)
{
  const int type = kindOf(cellType).straightType;
  return type > 0 ? type : cellType;
}

std::int64_t fewestPointsOf(int cellType)
{
  return kindOf(cellType).points;
}

bool canHavePoints(int cellType, std::int64_t points, const double* degrees)
{
  if (cellType == quadraticPolygonType)
  {
    return points >= 6 && points % 2 == 0;
  }
  if (pointsOfDegrees(cellType, 1, 1, 1) == 0)
  {
    return points >= fewestPointsOf(cellType);
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

const FaceTable& facesOf(int cellType)
{
  static const std::array<FaceTable, 8> tables = {{
    {0, 1, 3, -1, 1, 2, 3, -1, 2, 0, 3, -1, 0, 2, 1, -1},
    {0, 4, 6, 2, -1, 1, 3, 7, 5, -1, 0, 1, 5, 4, -1, 2, 6, 7, 3, -1, 0, 2, 3, 1, -1, 4, 5, 7, 6,
      -1},
    {0, 4, 7, 3, -1, 1, 2, 6, 5, -1, 0, 1, 5, 4, -1, 3, 7, 6, 2, -1, 0, 3, 2, 1, -1, 4, 5, 6, 7,
      -1},
    {0, 1, 2, -1, 3, 5, 4, -1, 0, 3, 4, 1, -1, 1, 4, 5, 2, -1, 2, 5, 3, 0, -1},
    {0, 3, 2, 1, -1, 0, 1, 4, -1, 1, 2, 4, -1, 2, 3, 4, -1, 3, 0, 4, -1},
    {0, 4, 3, 2, 1, -1, 5, 6, 7, 8, 9, -1, 0, 1, 6, 5, -1, 1, 2, 7, 6, -1, 2, 3, 8, 7, -1, 3, 4, 9,
      8, -1, 4, 0, 5, 9, -1},
    {0, 5, 4, 3, 2, 1, -1, 6, 7, 8, 9, 10, 11, -1, 0, 1, 7, 6, -1, 1, 2, 8, 7, -1, 2, 3, 9, 8, -1,
      3, 4, 10, 9, -1, 4, 5, 11, 10, -1, 5, 0, 6, 11, -1},
    {},
  }};
  return tables[cellType < tetra || cellType > hexagonalPrism
                  ? tables.size() - 1
                  : static_cast<std::size_t>(cellType - tetra)];
}

} // namespace winding
