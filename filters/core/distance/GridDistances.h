// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/FieldOutput.h"
#include "distance/DistanceTree.h"
#include "distance/NearestNumbers.h"
#include "source/Grid.h"

#include <vector>

namespace winding
{

/**
 * Distances of the samples of a grid, found for cells of samples rather than one by one: from large
 * cells down to a few samples, each with a list of what may be nearest to any of its
 * samples (CellDescent.h).
 *
 * Blocks belong to the whole grid, whatever part of it is asked for. Guaranteed: the bits of a
 * distance depend on the source and the sample only.
 *
 * A task is a block of samples. Where lists stay long, as about the centre of a sphere, it ends
 * after some cells and leaves the others to further tasks, so that executors can be interrupted in
 * between.
 */
class GridDistances
{
public:
  /// Stands for the samples of an extent of the grid. Keeps references to the tree, the grid and
  /// the output.
  GridDistances(
    const DistanceTree& tree, const Grid& grid, const Extent& extent, const FieldOutput& output);

  /// Writes the distances. Throws Interrupted.
  void evaluate(Executor& executor) const;

  /// Writes the numbers of the items that are nearest to the samples, in the same way, and leaves
  /// the output of distances alone. Throws Interrupted.
  void findNumbers(const NumberOutput& output, Executor& executor) const;

private:
  std::vector<Extent> blocks() const;
  Extent samplesOfBlock(std::size_t number) const;

  const DistanceTree& tree_;
  const Grid& grid_;
  const Extent extent_;
  const FieldOutput& output_;
  Eigen::Vector3i blockSize_;   ///< samples of a block along each axis
  Eigen::Vector3i firstBlock_;  ///< first block that the extent reaches into
  Eigen::Vector3i blockCounts_; ///< number of blocks along each axis that it reaches into
};

} // namespace winding
