// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "source/Surface.h"
#include "surface/ClosedComponents.h"

namespace winding
{

/// The triangles to turn round, and to leave out, so that a surface has an outside.
struct Orientation
{
  std::vector<char> isTurned;  ///< by triangle
  std::vector<char> isLeftOut; ///< by triangle; empty where all stay
  std::size_t triangles = 0;   ///< number of triangles that are turned
  /// The number of components with a triangle that is turned, as Components counts them afterwards.
  std::size_t components = 0;
};

/**
 * Finds an orientation. Faces that are there more than once are left out first, so that each
 * bounds once (RepeatedFaces.h). Walls between solids, which are pairs, stay as they are. Of open
 * sheets drawn from both sides, those inside of closed parts are left out with both (OpenParts.h).
 * Three steps follow:
 * 1. Triangles that share an edge with no third one are made to run along it in opposite
 *    directions, and triangles of a polygon keep the sense that they have in common. A patch, a
 *    connected set of these triangles, that admits this is turned as a whole from here on, at first
 *    so that at most half of its area is turned. A patch that does not, a Möbius strip say, stays
 *    as it is.
 * 2. Where more than two triangles meet and contradict each other, holes being capped (OddCaps.h),
 *    patches that are connected with them are turned so that the regions that they separate are
 *    empty and solid in turn (Shells.h). Where that is unclear, patches are turned, small ones
 *    first, as long as that makes more of the triangles cancel.
 * 3. Components (Components.h) that are tightly closed then (NearlyClosed.h) are turned so that
 *    those inside an even number of others are oriented outward, and those inside an odd number,
 *    cavities, inward (ClosedComponents.h). Nearly closed components are turned likewise, except
 *    that other nearly closed ones count for them, too. A component whose triangles agreed stays
 *    where these make the difference, as a ball in a tub. Open or flat components are turned so
 *    that at most half of their area is turned, or outward if flat lids would close them
 *    (Openings.h). Components with a patch that stays in step 1 stay as they are.
 *
 * So a surface whose triangles agree stays as it is, except for inverted components, nested solids
 * and faces that are there more than once in one sense. The result depends on the set of triangles
 * and polygons, not on their order; equal faces are interchangeable. It is the same
 * for every executor. Takes O(n log n) time, and the time of ClosedComponents.h where components
 * are nested. Throws Interrupted.
 */
Orientation orient(const Surface& surface, const PolygonParts& parts, Executor& executor);

/// Turns triangles of a surface round, and removes those that are left out.
void apply(const Orientation& orientation, Surface& surface);

/// Counts of what keeps triangles from agreeing. Patches are sets of triangles connected through
/// edges that two triangles share.
struct Contradictions
{
  std::size_t oneSided = 0;          ///< patches that no turning can make agree
  std::size_t oneSidedTriangles = 0; ///< of these patches
  std::size_t edges = 0; ///< edges in other patches that two triangles use in the same sense
};

Contradictions contradictionsOf(const Surface& surface, const SurfaceEdges& edges);

} // namespace winding
