// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/SolidShape.h"
#include "distance/DistanceTree.h"
#include "level/EdgeRoots.h"

namespace winding
{

/**
 * Finds where the edges of a solid's shape cross the limits of its band: the places at the exact
 * distance from the surface. `edges` are the shape's (BandSamples.h). `solid` and `solidRoots` are
 * the solid's, and `tree` holds its surface. Edges that `others` has, too, get no root.
 *
 * The distance along an edge is the least of the distances from single items, and these are
 * convex. So the root for the item that is nearest somewhere is found by Newton's method. Where
 * another item is nearer there, its root is farther on. Few items are looked at before none is.
 *
 * Guaranteed: a root is off the limit by rounding, or by at most 2⁻²⁰ of the edge's length; normals
 * point to or from the nearest place of the surface. A limit of 0 has the solid's own roots. The
 * bits are the same for every executor. Throws Interrupted.
 */
EdgeRoots bandRoots(const DistanceTree& tree, const Grid& grid, const LevelEdges& edges,
  const LevelEdges& solid, const EdgeRoots& solidRoots, const DistanceBand& band,
  Executor& executor, const LevelEdges* others = nullptr);

} // namespace winding
