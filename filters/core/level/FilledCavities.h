// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "distance/DistanceTree.h"
#include "level/EdgeRoots.h"

#include <cstddef>
#include <memory>

namespace winding
{

/**
 * A solid whose cavities are filled: samples that the outside does not reach become inside. The
 * outside spreads from the border of the grid, from sample to sample along its axes. So a gap
 * narrower than a voxel may let it in, or not.
 *
 * The outside spreads where it is farther than r from the source, with a gap width g. The square
 * of r is (g² + h²) / 4 for the longest edge h of a voxel: so no opening as wide as g lets it in.
 * It grows back by r then. What it does not reach is a cavity where a place in it is
 * farther than r from the surface; grooves of the outside are none. Walls of cavities may be
 * thinner than a voxel. Openings are closed about where their rims are. Where the border of the
 * grid is nearer than r to the surface, only cavities are filled that no opening leads to.
 *
 * Guaranteed: the same for every executor. Time: n log n in the edges and rows, and with a gap
 * width as for two shapes with an offset (BandSamples.h).
 */
struct FilledCavities
{
  /// Fills the cavities of a solid by its edges, which are done, and their roots. `tree` has the
  /// surface of the source; it may be null without a gap width. Keeps a reference to the grid.
  /// Throws Interrupted.
  FilledCavities(const LevelEdges& solid, const EdgeRoots& solidRoots, const Grid& grid,
    double gapWidth, const DistanceTree* tree, Executor& executor);

  /// Returns the memory of the search for cavities among `edges` edges, in bytes.
  static double bytesFor(const Grid& grid, double edges);

  std::size_t count = 0; ///< of cavities
  bool isTight = false;  ///< whether the border is too near the surface for the gap width
  std::unique_ptr<const LevelEdges> edges;
  EdgeRoots roots = EdgeRoots(0);
};

} // namespace winding
