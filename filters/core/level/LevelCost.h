#pragma once

#include "base/EvaluationCost.h"
#include "base/Executor.h"
#include "base/InsideRule.h"
#include "field/Field.h"

namespace winding
{

/// The number of edges of a grid that the surface of a source crosses, if its triangles or points
/// face all directions alike. The level surface crosses about as many. It crosses far fewer where
/// triangles lie one behind the other, or outside the grid.
double levelEdgesByArea(const Field& field, const Grid& grid);

/**
 * An estimate of the same number for such sources: the crossed edges of a coarser grid, of at most
 * 64 samples along each axis, times those that it stands for. It is too small where the surface has
 * details that the coarse grid does not see. Throws Interrupted.
 */
double levelEdgesByCoarseGrid(const Field& field, const Grid& grid, InsideRule rule,
  double threshold, bool withBorder, Executor& executor);

/**
 * The cost that the level surface of a field on a grid is expected to have in addition to the field
 * itself (LevelEdges.h, EdgeCrossings.h, LevelRoots.h), if it crosses so many edges. The seconds
 * are less than 0 where the field of a closed surface is spared the writing of its values. The
 * bytes are those of everything that grows with the edges, among them the surface with its normals.
 */
EvaluationCost costOfLevelSurface(const Field& field, const Grid& grid, double edges);

} // namespace winding
