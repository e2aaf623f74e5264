#pragma once

#include <cstdint>
#include <vector>

class vtkCellArray;

namespace winding
{

/// Point ids of triangles, three each. A polygon becomes the fan from its first vertex: for planar
/// polygons the right chain, convex or not. Cells of less than three points give none.
std::vector<std::int64_t> trianglesOfPolygons(vtkCellArray* polygons);

/// The same of triangle strips.
std::vector<std::int64_t> trianglesOfStrips(vtkCellArray* strips);

} // namespace winding
