#pragma once

#include "base/Bounds.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace winding
{

/// Three vertex ids; positive orientation is counter-clockwise seen from outside.
using Triangle = std::array<std::int32_t, 3>;

/**
 * A clean triangle chain, as sanitize() makes it. Properties: (1) all coordinates are finite and −0
 * does not occur; (2) no two vertices are equal, every vertex belongs to a triangle, and vertices
 * stand in the order of the input's points, each in the place of the first point equal to it;
 * (3) the three ids of a triangle are valid and differ; (4) triangles keep their order.
 * Duplicate, opposite and zero-area triangles stay: the formulas give them their exact share.
 */
struct Surface
{
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Triangle> triangles;
  Bounds bounds; ///< box of the vertices; empty when there are none

  std::size_t inputTriangles = 0;
  std::size_t nonFiniteTriangles = 0; ///< dropped: a corner is NaN or infinite
  std::size_t invalidIdTriangles = 0; ///< dropped: a corner is no point of the input
  std::size_t collapsedTriangles = 0; ///< left out: two corners equal, so they bound nothing

  std::size_t dropped() const { return nonFiniteTriangles + invalidIdTriangles; }
};

} // namespace winding
