// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/FreeMemory.h"

#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
class vtkUnstructuredGrid;
VTK_ABI_NAMESPACE_END

namespace winding
{

/// The bytes that clippedPart() takes for each point, in addition to its result and what VTK takes.
constexpr double bytesPerClippedPoint = 9;

/**
 * The part of a data set in which numbers at its points, interpolated along edges, are more than 0,
 * with all arrays of the data set. Cells are cut by vtkTableBasedClipDataSet. Cells of a point that
 * is NaN or infinite are left out. A data set without cells counts as points with a vertex each.
 *
 * The cells of the data set were checked (CellChecks.h); `numbers` has an entry for each point, and
 * none is 0. Points are double where the data set's are not stored as float. Throws
 * OutOfMemory, before VTK begins, where the part would not fit; `memory` says what there is.
 */
vtkSmartPointer<vtkUnstructuredGrid> clippedPart(
  vtkDataSet* data, const double* numbers, HostMemory (*memory)() = hostMemory);

} // namespace winding
