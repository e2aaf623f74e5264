// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/SideCounts.h"
#include "rays/RowCrossings.h"

#include <functional>
#include <vector>

namespace winding
{

/// The runs of equal values in some layers of a grid, kept so that any cube of voxels can be asked
/// whether it has one value. Memory: 8 bytes for each run, and 4 for each row.
class RunsOfLayers
{
public:
  /// The label of a value; neighbours of a row with the same label make one run.
  using LabelOf = std::function<int(int value)>;

  /// Finds the runs of layers `first` to `last`. Throws Interrupted.
  RunsOfLayers(const RowCrossings& rows, const Grid& grid, int first, int last,
    const LabelOf& labelOf, InsideRule rule, double threshold, Executor& executor);

  /// Whether all of the cube's voxels, `size` along each axis from (i, j, k) on, have one label.
  bool areEqual(int i, int j, int k, int size) const;

  /// The label of a voxel.
  int label(int i, int j, int k) const { return this->runAt(i, j, k)->label; }

  /// The sides of all samples of the layers, by rule and threshold.
  const SideCounts& sides() const { return sides_; }

private:
  struct Run
  {
    int end; ///< behind the last sample
    int label;
  };

  /// The runs of some rows of a layer.
  struct Block
  {
    std::vector<std::uint32_t> starts; ///< first run of each row
    std::vector<Run> runs;
  };

  const Run* runAt(int i, int j, int k) const;

  int firstLayer_;
  RowBands bands_;
  std::size_t bandsPerLayer_;
  std::vector<Block> blocks_; ///< band by band, layer by layer
  SideCounts sides_;
};

} // namespace winding
