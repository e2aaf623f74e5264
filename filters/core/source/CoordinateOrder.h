#pragma once

#include "base/Executor.h"
#include "source/CompareCoordinates.h"
#include "source/PointCloud.h"
#include "source/Surface.h"

#include <cstdint>
#include <vector>

/**
 * @file
 * Orders that follow from coordinates alone. Sums of floating-point numbers depend on the order of
 * what is added: where a source is brought into such an order first, they depend on the set of its
 * primitives, whatever order, blocks and vertex numbers these came in. Primitives that no order
 * tells apart are equal in all numbers, so that it does not matter which of them comes first.
 */
namespace winding
{

/// Turns a triangle so that its lowest corner, by compareCoordinates(), comes first: the three ways
/// to write an oriented triangle become one. No two vertices may be equal.
inline Triangle lowestFirst(const std::vector<Eigen::Vector3d>& vertices, const Triangle& triangle)
{
  const auto isBefore = [&](int i, int j)
  {
    return compareCoordinates(vertices[triangle[i]], vertices[triangle[j]]) < 0;
  };
  const int lower = isBefore(1, 0) ? 1 : 0;
  const int first = isBefore(2, lower) ? 2 : lower;
  return first == 0   ? triangle
         : first == 1 ? Triangle{triangle[1], triangle[2], triangle[0]}
                      : Triangle{triangle[2], triangle[0], triangle[1]};
}

/// Turns a triangle so that its corners stand in the first of their three orders. It does what
/// lowestFirst() does, but corners may be equal.
void turnToFirstOrder(Eigen::Vector3d (&corners)[3]);

/// Compares two triangles by their corners in ascending order, then by their sense, as
/// compareCoordinates() does; both stand with their lowest corners first. Reversing all triangles
/// does not change the order of those that differ in more than their sense.
int compareTriangles(
  const std::vector<Eigen::Vector3d>& vertices, const Triangle& a, const Triangle& b);

/// Triangles with their multiplicities, as ChainView refers to them.
struct OrderedTriangles
{
  std::vector<Triangle> triangles;
  Multiplicities multiplicities;
};

/// The triangles of a chain, each with its lowest corner first: by ascending multiplicity, and those
/// of one multiplicity by compareTriangles(). Takes O(n log n) time on one thread.
OrderedTriangles inCoordinateOrder(
  const std::vector<Eigen::Vector3d>& vertices, const ChainView& chain);

/**
 * The numbers of a cloud's points in an order that depends on their positions, normals, areas and
 * regularization lengths alone. Points near to each other mostly stand near to each other. Takes
 * the time of a SourceTree. Throws Interrupted.
 */
std::vector<std::uint32_t> coordinateOrder(
  const PointCloud& cloud, const std::vector<double>& areas, Executor& executor);

} // namespace winding
