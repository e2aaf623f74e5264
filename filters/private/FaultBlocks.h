#pragma once

#include "base/Executor.h"
#include "source/Surface.h"
#include "surface/SurfaceEdges.h"

#include "vtkSmartPointer.h"

class vtkMultiBlockDataSet;

namespace winding
{

/**
 * What is wrong with a surface, as polydata to look at; in this order, and those that are empty too:
 * | block             | cells | cell data |
 * |-------------------|-------|-----------|
 * | Boundary          | closed polylines: the loops of the net boundary (Boundary.h), which are run along once for each time that an edge does not cancel | Loop: its number; Edges; Multiplicity: the largest of its edges' |
 * | Caps              | triangles that close the loops (Cap.h), as the field takes them | Loop |
 * | NonManifoldEdges  | lines: edges that more than two triangles use | Triangles: how many |
 * | InconsistentEdges | lines: edges that two triangles use in the same direction | |
 *
 * The points of a block are the vertices that it uses, in their order; pointType is their VTK type.
 * Throws Interrupted.
 */
vtkSmartPointer<vtkMultiBlockDataSet> faultBlocks(
  const Surface& surface, const SurfaceEdges& edges, int pointType, Executor& executor);

/// The same blocks, all empty.
vtkSmartPointer<vtkMultiBlockDataSet> noFaults();

} // namespace winding
