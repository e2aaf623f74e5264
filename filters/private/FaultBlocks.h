#pragma once

#include "base/Executor.h"
#include "source/Surface.h"
#include "surface/SurfaceEdges.h"

#include "vtkSmartPointer.h"

class vtkMultiBlockDataSet;

namespace winding
{

/**
 * The faults of a surface, as polydata to look at. The blocks have this order; a block without a
 * fault is there, but empty:
 * - Boundary: the loops of the net boundary (Boundary.h) as closed polylines, which run along an
 *   edge once for each time that it does not cancel. Cell data: Loop, the loop's number; Edges, the
 *   number of its edges; Multiplicity, the largest of its edges' multiplicities.
 * - Caps: the triangles that close the loops (Cap.h), as the field takes them. Cell data: Loop.
 * - NonManifoldEdges: the edges that more than two triangles use, as lines. Cell data: Triangles,
 *   the number of triangles that use the edge.
 * - InconsistentEdges: the edges that two triangles use in the same direction, as lines.
 *
 * The points of a block are the vertices that it uses, in their order; pointType is their VTK type.
 * Throws Interrupted.
 */
vtkSmartPointer<vtkMultiBlockDataSet> faultBlocks(
  const Surface& surface, const SurfaceEdges& edges, int pointType, Executor& executor);

/// The blocks of a surface without faults: all are empty.
vtkSmartPointer<vtkMultiBlockDataSet> noFaults();

} // namespace winding
