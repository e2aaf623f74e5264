// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "source/Surface.h"
#include "surface/SurfaceEdges.h"

#include <cstdint>
#include <vector>

namespace winding
{

/**
 * The shells of a surface: connected sets of sides of its triangles that bound one region of space.
 * A triangle has two sides, and its normal points away from the front.
 *
 * Around an edge that triangles share, sides that face each other are of one shell: their order is
 * by the angle (Guéziec and others 2001; Zhou and others 2016). At an edge of one triangle the two
 * sides of it are of one shell. The surface may be oriented in any way.
 */
class Shells
{
public:
  /// Finds all shells in O(n log n) time. No two triangles may be equal.
  Shells(const Surface& surface, const SurfaceEdges& edges);

  /// A region, as far as the connected surface knows that bounds it.
  enum class Region : char
  {
    unclear, ///< triangles lie on one another, a surface is open, or regions contradict
    empty,
    solid
  };

  /**
   * Returns for each side, front and back of one triangle after the other, what is before it.
   *
   * `counts` says how many faces each triangle represents; 0 for a cap, which parts regions and
   * says nothing about them. Each face bounds a solid on one of its sides, and a solid that was
   * drawn n times has n faces everywhere. So the numbers of a region and of its neighbour behind a
   * triangle add up to the triangle's count, from the outside on, which has 0. Between two regions
   * the count of most triangles holds. A region is empty with 0 and solid with more. It is unclear
   * where one way leads to a solid and another to none, and where it lies on both sides of an odd
   * number of faces, through a hole. An even number may be a fin, which bounds nothing.
   */
  std::vector<Region> regions(const std::vector<std::int32_t>& counts) const;

  /// Returns for each triangle whether the senses of all that are connected with it contradict each
  /// other: w, which is one more behind a triangle than before it, would differ by the way.
  /// `isTurned` says which triangles count as turned round; `counts` is 0 for caps.
  std::vector<char> contradict(
    const std::vector<char>& isTurned, const std::vector<std::int32_t>& counts) const;

private:
  void joinAround(const Surface& surface, const SurfaceEdges& edges,
    const SurfaceEdges::Crowd& crowd, std::vector<std::int32_t>& unclearSides);
  void measure(const Surface& surface, const std::vector<std::int32_t>& unclearSides);

  DisjointSets sets_;                ///< of sides
  std::vector<std::int32_t> shells_; ///< by side: the first side of its shell
  std::vector<Region> byVolume_;     ///< by shell: empty for an outside, solid for bounded ones
};

} // namespace winding
