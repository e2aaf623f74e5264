#pragma once

#include "base/Executor.h"
#include "source/Surface.h"
#include "surface/ClosedComponents.h"

namespace winding
{

/// Which triangles to turn round, so that a surface has an outside.
struct Orientation
{
  std::vector<char> isTurned; ///< by triangle
  std::size_t triangles = 0;  ///< that are turned
  std::size_t components =
    0; ///< with a triangle that is turned, as Components counts them afterwards
};

/**
 * Finds an orientation:
 * 1. Triangles that share an edge with no third one are made to run along it in opposite directions, and
 *    those of a polygon keep the sense that they have in common. What admits that is turned as a whole
 *    from here on, at first so that less than half of its area is turned. What does not, a Möbius strip
 *    say, stays as it is.
 * 2. Where more than two triangles meet, parts of 1 are turned, small ones first, as long as that makes
 *    more of what meets there cancel.
 * 3. Components (Components.h) that are closed then are turned so that those inside an even number of
 *    other closed ones are oriented outward, and those inside an odd number, cavities, inward
 *    (ClosedComponents.h). So are those that are nearly closed (NearlyClosed.h), where others that are
 *    nearly closed count, too. What is open, or flat, is turned so that at most half of its area is
 *    turned. Components with a part that stays in 1 stay as they are.
 *
 * So a surface whose triangles agree stays as it is, but for what is inverted and for nested solids.
 * The same for every executor. O(n log n) time. Throws Interrupted.
 */
Orientation orient(
  const Surface& surface, const SurfaceEdges& edges, const PolygonParts& parts, Executor& executor);

/// How many parts, connected through edges that two triangles share, no turning could make agree:
/// they have one side only.
std::size_t countOneSided(const Surface& surface, const SurfaceEdges& edges);

} // namespace winding
