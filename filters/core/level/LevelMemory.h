// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
double levelEdgesByCoarseGrid(const Field& field, const Grid& grid, const InsideTest& isInside,
  bool withBorder, Executor& executor);

/// Returns the memory that the level surface of a field takes in addition if it crosses `edges`
/// edges of the grid: of everything that grows with them, the surface with its normals included.
std::size_t bytesOfLevelSurface(const Field& field, double edges);

/// Returns the memory of a result of several solids, which crosses `edges` edges of the grid if it
/// crosses all of theirs: its own edges and roots, and its surface.
std::size_t bytesOfCombinedSurface(const Grid& grid, double edges);

} // namespace winding
