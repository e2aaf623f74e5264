// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkWindingABINamespace.h"

#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkCellArray;
VTK_ABI_NAMESPACE_END

namespace winding
{

/// Triangles of polygons: their point ids, three each, and whether each belongs to the polygon of
/// the triangle before it.
struct FlatTriangles
{
  std::vector<std::int64_t> ids;
  std::vector<char> isContinued;
};

/// Divides polygons into triangles. A polygon becomes the fan from its first vertex, which is the
/// right chain for planar polygons, convex or not. A cell of less than three points gives none.
FlatTriangles trianglesOfPolygons(vtkCellArray* polygons);

/// The point ids of the strips' triangles, three each, all oriented as the strip is.
std::vector<std::int64_t> trianglesOfStrips(vtkCellArray* strips);

} // namespace winding
