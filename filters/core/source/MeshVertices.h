#pragma once

#include "base/Views.h"

#include <cstddef>

#include <vector>

namespace winding
{

class Executor;

/// The points of a mesh as oriented points, numbered as in the mesh.
struct MeshVertices
{
  /// Normals, three numbers for each point: the sum of the area vectors of the triangles around it,
  /// not of unit length. 0 for points without triangles.
  std::vector<double> normals;
  /// A third of the areas of the triangles around each point; the sum over all points is the area
  /// of the mesh.
  std::vector<double> areas;
};

/// Normals and areas from triangles of several views over the same points, of which there are
/// `points`. Triangles with invalid ids or corners that are not finite are left out. The bits
/// depend on the set of oriented triangles around each point, not on their order nor on threads:
/// shares are rounded such that their sums are exact, by 2⁻⁴⁸ of the product of the two shortest
/// sides of a triangle around the point, times their number, at most. Areas beyond 2⁹⁰⁰ are summed
/// without that. Takes linear time, on two threads at most, and 80 bytes per point while it runs.
/// Throws Interrupted.
MeshVertices meshVertices(
  const std::vector<TrianglesView>& views, std::size_t points, Executor& executor);

} // namespace winding
