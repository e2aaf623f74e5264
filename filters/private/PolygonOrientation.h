#pragma once

#include "base/Executor.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <vector>

class vtkPolyData;

namespace winding
{

/// Surfaces that are one source, with their polygons oriented (Orientation.h).
struct OrientedPolygons
{
  std::vector<vtkSmartPointer<vtkPolyData>> leaves;
  std::size_t triangles = 0;  ///< turned; polygons are fans
  std::size_t components = 0; ///< in which some are
};

/**
 * Turns polygons round, which keep their first point. The strips of a leaf in which something is turned
 * become triangles, each with the cell data of its strip. Points, point data, cell data and all other
 * cells stay as they are, and a leaf in which nothing is turned is the one that came in. Ghost cells are
 * not looked at, and stay.
 *
 * Throws Refusal for leaves with bad triangles only, and Interrupted.
 */
OrientedPolygons orientPolygons(
  const std::vector<vtkSmartPointer<vtkPolyData>>& leaves, Executor& executor);

} // namespace winding
