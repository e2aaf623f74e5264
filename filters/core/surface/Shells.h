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
    unclear, ///< a shell has a rim or triangles that lie on one another, or regions contradict
    empty,
    solid
  };

  /**
   * Returns for each side, front and back of one triangle after the other, what is before it. The
   * outside is empty. Triangles whose entry of `separates` is not 0 have a solid on one side, and
   * an empty region on the other. A bounded region that has no triangle of these is solid.
   */
  std::vector<Region> regions(const std::vector<char>& separates) const;

private:
  void joinAround(const Surface& surface, const SurfaceEdges& edges,
    const SurfaceEdges::Crowd& crowd, std::vector<std::int32_t>& unclearSides);
  void measure(const Surface& surface, const std::vector<std::int32_t>& unclearSides);

  DisjointSets sets_;                ///< of sides
  std::vector<std::int32_t> shells_; ///< by side: the first side of its shell
  std::vector<Region> byVolume_;     ///< by shell: empty if it is an outside, or else solid
};

} // namespace winding
