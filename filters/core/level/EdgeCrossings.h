// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/CountingSort.h"
#include "base/Executor.h"
#include "level/LevelEdges.h"
#include "source/Surface.h"

namespace winding
{

/**
 * The crossings of a surface with those edges of a grid that a level crosses. They are found from
 * the triangles, each of which knows the lines of samples that it meets (RowTriangle.h), so that no
 * triangle is asked about an edge that it is not near to.
 *
 * Guaranteed: (1) an edge whose line crosses the surface between its two samples has that crossing,
 * whatever the rounding; where the line meets an edge or a vertex of the surface, one of the
 * triangles there has it; (2) the place of a crossing is right up to rounding, or anywhere on the
 * triangle where that lies along the line; (3) the bits are the same for any executor, and depend
 * on the set of oriented triangles, not on their order.
 *
 * A sample on the surface is counted to one of its sides along each axis (RowTriangle.h), so that a
 * crossing there belongs to one of the two edges that meet there; the other edge has it, too, as
 * one by which w does not change.
 *
 * Time: linear in the triangles, the edges and the crossings of the lines of the grid. Memory: 24
 * bytes per vertex of the surface, and about 70 for each edge.
 */
class EdgeCrossings
{
public:
  /// Finds the crossings. Throws Interrupted.
  EdgeCrossings(
    const Surface& surface, const Grid& grid, const LevelEdges& edges, Executor& executor);

  /// A crossing within this fraction of an edge from a sample may lie on the sample except for
  /// rounding.
  static constexpr double atSample = 1.0 / (1 << 20);

  struct Crossing
  {
    double fraction;        ///< 0 at the edge's first sample, 1 at its second
    Eigen::Vector3f normal; ///< unit normal of the triangle, or 0 where rounding leaves none
    int change;             ///< change of w along the edge; 0 as said for the class
  };

  ///@{
  /// The crossings of an edge, by ascending fraction.
  const Crossing* begin(std::size_t edge) const { return crossings_.begin(edge); }
  const Crossing* end(std::size_t edge) const { return crossings_.end(edge); }
  ///@}

private:
  CountingSort<Crossing> crossings_; ///< by edge
};

} // namespace winding
