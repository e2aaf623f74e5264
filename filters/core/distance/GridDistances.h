#pragma once

#include "base/Executor.h"
#include "base/FieldOutput.h"
#include "distance/DistanceTree.h"
#include "source/Grid.h"

#include <vector>

namespace winding
{

/**
 * Distances of the samples of a grid, found for cells of samples rather than one by one: from large
 * cells down to those of a few samples, each with a list of the nodes that may be nearest to any of
 * its samples. The list is short because of this: let x be the point of the source nearest to the
 * cell's centre. A node can be dropped if x is nearer than it to every sample of the cell; and
 * dist²(q, box) − |q − x|² need only be looked at in the corners q of the cell, where it is
 * smallest, as for each point of the box it is linear in q. Its smallest value is the sum of the
 * smallest values along each axis.
 *
 * Rounding turns x into a point x' within δ of the source (roundingOfOffset, and the rounding of
 * its coordinates). So the source is no farther from q than |q − x'| + δ. A node is dropped only
 * where it is farther than that from all q, and by ε more, the rounding of the distances that are
 * compared. The corners still suffice, as (|q − x'| + δ + ε)² is the sum of |q − x'|² and a convex
 * function of q. δ and ε are relative to the whole source, not to the cell, which may lie beside a
 * vertex and be as small. The item that x' was found on is kept whatever is computed: so no list is
 * empty but those of cells that are beyond the limit, and where the bound fails (for needles),
 * distances are as inexact as the loops' own.
 *
 * Cells and lists are those of the whole grid, whatever part of it is asked for, and so are the
 * bits.
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

  /// Writes the distances. Returns false when the executor was interrupted.
  bool evaluate(Executor& executor) const;

private:
  class Descent;

  /// The part of a block that is still to be done.
  struct Piece
  {
    std::size_t block;
    Extent samples;
  };

  Extent samplesOfBlock(std::size_t number) const;

  const DistanceTree& tree_;
  const Grid& grid_;
  const Extent extent_;
  const FieldOutput& output_;
  Eigen::Vector3i blockSize_;  ///< samples of a block along each axis
  Eigen::Vector3i firstBlock_; ///< first block that the extent reaches into
  Eigen::Vector3i blocks_;     ///< number of blocks along each axis that it reaches into
};

} // namespace winding
