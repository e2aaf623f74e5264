#pragma once

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <utility>
#include <vector>

class vtkPointSet;
class vtkPolyData;

namespace winding
{

class Executor;

/// The cells of a data set that regions are made of, the first and the one past the last: polygons
/// and strips of polydata, all cells of other data.
std::pair<vtkIdType, vtkIdType> facesOf(vtkPointSet* data);

/// The polygons and strips of each of the solids that a surface is made of (SolidParts.h), by their
/// ids as cells. Strips belong to one solid. `ignoresOpenParts` leaves out those inside of closed
/// ones (OpenParts.h). Throws Interrupted, and a Refusal if there is no usable polygon.
std::vector<std::vector<vtkIdType>> solidCellsOf(
  vtkPolyData* surface, bool ignoresOpenParts, Executor& executor);

/**
 * Some of the cells of a data set, in their order, with the points that they use. The cells of
 * polydata are polygons and strips, and keep ids of points that do not exist. `newIds` is −1 for
 * each point between calls, or empty before the first: it is what makes many small regions of one
 * surface take no more time than one.
 */
vtkSmartPointer<vtkPointSet> cellsOf(
  vtkPointSet* data, const std::vector<vtkIdType>& cells, std::vector<vtkIdType>& newIds);

} // namespace winding
