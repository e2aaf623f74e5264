// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
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

/// Turns a triangle so that its lowest corner comes first: the three ways to write an oriented
/// triangle become one. compare(i, j) compares two vertices, no two of which may be equal.
template <class Compare> Triangle lowestFirst(const Triangle& triangle, const Compare& compare)
{
  const auto [a, b, c] = triangle;
  if (compare(b, a) < 0)
  {
    return compare(c, b) < 0 ? Triangle{c, a, b} : Triangle{b, c, a};
  }
  return compare(c, a) < 0 ? Triangle{c, a, b} : triangle;
}

/// Turns a triangle so that its lowest corner comes first, by the coordinates of the vertices.
inline Triangle lowestFirst(const std::vector<Eigen::Vector3d>& vertices, const Triangle& triangle)
{
  return lowestFirst(triangle, [&vertices](std::int32_t i, std::int32_t j)
    { return compareCoordinates(vertices[i], vertices[j]); });
}

/// Turns a triangle so that its corners stand in the first of their three orders. It does what
/// lowestFirst() does, but corners may be equal.
void turnToFirstOrder(Eigen::Vector3d (&corners)[3]);

/// Compares two triangles by their corners in ascending order, then by their sense; both stand with
/// their lowest corners first. Reversing all triangles does not change the order of those that
/// differ in more than their sense. compare(i, j) compares two vertices.
template <class Compare>
int compareTriangles(const Triangle& a, const Triangle& b, const Compare& compare)
{
  const bool isUpward = compare(a[1], a[2]) < 0, isOtherUpward = compare(b[1], b[2]) < 0;
  const Triangle sorted = isUpward ? a : Triangle{a[0], a[2], a[1]};
  const Triangle other = isOtherUpward ? b : Triangle{b[0], b[2], b[1]};
  int result = 0;
  for (std::size_t corner = 0; result == 0 && corner < 3; ++corner)
  {
    result = compare(sorted[corner], other[corner]);
  }
  return result != 0 ? result : static_cast<int>(isOtherUpward) - static_cast<int>(isUpward);
}

/// Compares two triangles by the coordinates of the vertices.
inline int compareTriangles(
  const std::vector<Eigen::Vector3d>& vertices, const Triangle& a, const Triangle& b)
{
  return compareTriangles(a, b,
    [&vertices](std::int32_t i, std::int32_t j)
    { return compareCoordinates(vertices[i], vertices[j]); });
}

/// Triangles with their multiplicities, as ChainView refers to them.
struct OrderedTriangles
{
  TriangleList triangles;
  Multiplicities multiplicities;
};

/**
 * The triangles of a chain, each with its lowest corner first: by ascending multiplicity, and those
 * of one multiplicity in an order that depends on their coordinates alone.
 *
 * The order goes by the distances of corners from the middle of the chain, along x, y and z: that
 * of a mirrored chain is the same, unless the chain mirrors itself. Takes O(n log n) time on one
 * thread.
 */
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
