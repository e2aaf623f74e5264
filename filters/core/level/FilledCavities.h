// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "level/EdgeRoots.h"

#include <cstddef>

namespace winding
{

/**
 * A solid whose cavities are filled: samples that the outside does not reach become inside. The
 * outside spreads from the border of the grid, from sample to sample along its axes. So a gap
 * narrower than a voxel may let it in, or not.
 *
 * Guaranteed: the same for every executor. Time: n log n in the edges and rows.
 */
struct FilledCavities
{
  /// Fills the cavities of a solid by its edges, which are done, and their roots. Throws
  /// Interrupted.
  FilledCavities(
    const LevelEdges& solid, const EdgeRoots& solidRoots, const Grid& grid, Executor& executor);

  /// Returns the memory of the search for cavities among `edges` edges, in bytes.
  static double bytesFor(const Grid& grid, double edges);

  std::size_t count; ///< of cavities
  LevelEdges edges;
  EdgeRoots roots;
};

} // namespace winding
