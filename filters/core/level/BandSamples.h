// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/SolidShape.h"
#include "distance/DistanceTree.h"
#include "level/LevelEdges.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace winding
{

/**
 * The samples of some layers of a grid whose signed distance lies in a band. Parts that no limit of
 * the band passes are settled as a whole, by the distance of their middle (CellDescent.h).
 *
 * Memory: a byte for each sample of the layers.
 */
class BandSamples
{
public:
  /// Layers that are best taken together.
  static constexpr int layersAtOnce = 16;

  /// Finds the samples in layers `first` to `end` - 1. `tree` holds the surface of `solid`, whose
  /// edges are done.
  BandSamples(const DistanceTree& tree, const LevelEdges& solid, const Grid& grid,
    const DistanceBand& band, int first, int end);

  /// Describes a row of these layers as runs with value 1 in the band and 0 elsewhere.
  void findRuns(int j, int k, std::vector<RowRun>& runs) const;

private:
  Extent extent_;                    ///< of the layers
  std::vector<std::uint8_t> states_; ///< inside the solid at first, then inside the band
};

/// Returns the edges of a band about the surface in `tree`. `solid` has that surface, and says
/// whether there is a border. Throws Interrupted.
std::unique_ptr<const LevelEdges> bandEdges(const DistanceTree& tree, const LevelEdges& solid,
  const Grid& grid, const DistanceBand& band, Executor& executor);

} // namespace winding
