#pragma once

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkDataSet;

namespace winding
{

/**
 * The part of a data set that is inside, with all of its arrays: of polydata as vtkPolyData, of any
 * other as vtkUnstructuredGrid. Cells keep their order, and points that no kept cell uses are left out.
 *
 * inside has an entry per point, or per cell if atCells. By points, cells are kept all of whose points
 * are inside; a data set without cells, or whose cells are poly-vertices only, is taken as points with
 * a vertex each, and what the poly-vertices carry is left out. Null if it has ids of points that do not
 * exist.
 */
vtkSmartPointer<vtkDataSet> insidePart(vtkDataSet* data, const unsigned char* inside, bool atCells);

} // namespace winding
