#pragma once

#include "base/Views.h"

#include <vector>

namespace winding
{

/// The vertices of a mesh seen as oriented points, by point of the mesh.
struct MeshVertices
{
  /// Three numbers each: the sum of the area vectors of the triangles around a point, not of unit
  /// length. 0 for points without triangles.
  std::vector<double> normals;
  /// A third of the areas of these triangles: together that of the mesh.
  std::vector<double> areas;
};

/// Of triangles over the same points, so many of them; those with invalid ids or corners that are not
/// finite are left out. Linear time.
MeshVertices meshVertices(const std::vector<TrianglesView>& views, std::size_t points);

} // namespace winding
