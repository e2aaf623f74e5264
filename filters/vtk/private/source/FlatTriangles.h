#pragma once

#include <cstdint>
#include <vector>

class vtkCellArray;

namespace winding
{

/// The point ids of the polygons' triangles, three each. A polygon becomes the fan from its first
/// vertex, which is the right chain for planar polygons, convex or not. A cell of less than three
/// points gives no triangle.
std::vector<std::int64_t> trianglesOfPolygons(vtkCellArray* polygons);

/// The point ids of the strips' triangles, three each, all oriented as the strip is.
std::vector<std::int64_t> trianglesOfStrips(vtkCellArray* strips);

} // namespace winding
