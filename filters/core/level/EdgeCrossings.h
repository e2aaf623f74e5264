#pragma once

#include "base/CountingSort.h"
#include "base/Executor.h"
#include "level/LevelEdges.h"
#include "source/Surface.h"

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
 * A sample on the surface is counted to one of its sides along each axis (RowTriangle.h), so that a
 * crossing there is that of one edge; the next edge has it as one by which w does not change.
 *
 * Time: linear in the triangles, the edges and the crossings of the lines of the grid. Memory: 24 bytes
 * per vertex of the surface, and about 70 for each edge.
 */
class EdgeCrossings
{
public:
  /// Throws Interrupted.
  EdgeCrossings(
    const Surface& surface, const Grid& grid, const LevelEdges& edges, Executor& executor);

  /// That near to a sample, rounding may have brought a crossing to it.
  static constexpr double atSample = 1.0 / (1 << 20);

  struct Crossing
  {
    double fraction;        ///< 0 at the edge's first sample, 1 at its second
    Eigen::Vector3f normal; ///< of the triangle, of unit length, or 0 where rounding leaves none
    int change;             ///< of w, walking along the edge: -1 or 1; or 0, see the class
  };

  ///@{
  /// Crossings of an edge, ascending.
  const Crossing* begin(std::size_t edge) const { return crossings_.begin(edge); }
  const Crossing* end(std::size_t edge) const { return crossings_.end(edge); }
  ///@}

private:
  CountingSort<Crossing> crossings_; ///< by edge
};

} // namespace winding
