#pragma once

#include "LevelEdges.h"

namespace winding
{

/**
 * Where a surface crosses the edges of a grid that a level does: found from the triangles, each of which knows the
 * lines of samples that it meets (RowTriangle.h), so that no triangle is asked about an edge that it
 * is not near to.
 *
 * Guaranteed: (1) an edge whose line crosses the surface between its two samples has that crossing,
 * whatever the rounding; where the line meets an edge or a vertex of the surface, one of the triangles
 * there has it; (2) places are right up to rounding, or anywhere on the triangle where it lies along
 * the line; (3) the same bits for any executor.
 *
 * Time: linear in the triangles, the edges and the crossings of the lines of the grid. Memory: 24 bytes
 * per vertex of the surface, and about 40 for each edge.
 */
class EdgeCrossings
{
public:
  /// Throws Interrupted.
  EdgeCrossings(
    const Surface& surface, const Grid& grid, const LevelEdges& edges, Executor& executor);

  ///@{
  /// Crossings of an edge, ascending: 0 at its first sample, 1 at its second.
  const double* begin(std::size_t edge) const { return fractions_.data() + starts_[edge]; }
  const double* end(std::size_t edge) const { return fractions_.data() + starts_[edge + 1]; }
  ///@}

private:
  std::vector<std::size_t> starts_; ///< of each edge's, and the end
  std::vector<double> fractions_;
};

} // namespace winding
