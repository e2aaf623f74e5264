#pragma once

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkPolyData;

/**
 * Polydata without the cells that have too few points for their kind: lines of one point, say,
 * which are a common way to give a point, and polygons of two. VTK's writers follow a null pointer
 * where there are any. Points and all other cells stay, with their data; the polydata itself
 * is returned if all cells have points enough. `dropped` becomes the number of cells left out.
 */
vtkSmartPointer<vtkPolyData> withoutSmallCells(vtkPolyData* data, vtkIdType& dropped);
