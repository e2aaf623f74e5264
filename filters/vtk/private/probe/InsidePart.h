// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWindingABINamespace.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
VTK_ABI_NAMESPACE_END

namespace winding
{

/**
 * The part of a data set that is inside, with all of its arrays. The part of polydata is
 * vtkPolyData, the part of any other data set vtkUnstructuredGrid. Cells keep their order, and
 * points that no kept cell uses are left out.
 *
 * `inside` has an entry for each point, or for each cell if atCells. With points, a cell is kept if
 * all of its points are inside; a data set without cells, or with poly-vertices only, counts as
 * points with a vertex each, and the cell data of the poly-vertices is left out. The cells of the
 * data set were checked (CellChecks.h).
 */
vtkSmartPointer<vtkDataSet> insidePart(vtkDataSet* data, const unsigned char* inside, bool atCells);

} // namespace winding
