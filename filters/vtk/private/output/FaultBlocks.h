// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "source/Surface.h"
#include "surface/Slits.h"
#include "surface/SurfaceEdges.h"

#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkMultiBlockDataSet;
VTK_ABI_NAMESPACE_END

namespace winding
{

/// The look of faults.
struct FaultShape
{
  int pointType; ///< VTK type of the points
  /// Radius of the tubes that lines become, in units of the diagonal of the surface's bounds; lines
  /// stay lines where it is 0, and of more than 20 000 edges of a kind.
  double thickness;
};

/**
 * The faults of a surface, as polydata to look at. Every kind has a place of its own among the
 * blocks, in this order, so that it has the same color in every view; the place is empty (null)
 * where there is no fault of the kind:
 * - Caps: the triangles that close the loops of the boundary (Cap.h), as the field takes them. Cell
 *   data: Loop, the loop's number.
 * - Boundary: the loops of the net boundary (Boundary.h) as closed polylines, which run along an
 *   edge once for each time that it does not cancel. Cell data: Loop; Edges, the number of its
 *   edges; Multiplicity, the largest of its edges' multiplicities;
 *   SlitWidth, the largest width of its edges of one triangle (Slits.h), NaN without any.
 * - NonManifoldEdges: the edges that more than two triangles use, as lines. Cell data: Triangles,
 *   the number of triangles that use the edge.
 * - InconsistentEdges: the edges that two triangles use in the same direction, as lines.
 *
 * Every block has the cell data FaultKind, its place among the blocks, as its active scalars.
 *
 * The points of a block are the vertices that it uses, in their order. Throws Interrupted.
 */
vtkSmartPointer<vtkMultiBlockDataSet> faultBlocks(const Surface& surface, const SurfaceEdges& edges,
  const Slits& slits, const FaultShape& shape, Executor& executor);

} // namespace winding
