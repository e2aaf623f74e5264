// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"

#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace winding
{

/// Surfaces that are one source, with their polygons oriented (Orientation.h).
struct OrientedPolygons
{
  std::vector<vtkSmartPointer<vtkPolyData>> leaves;
  std::size_t triangles = 0;  ///< number of triangles turned; polygons are fans
  std::size_t components = 0; ///< number of components in which some were turned
  std::size_t leftOut = 0;    ///< number of polygons left out
};

/**
 * Turns polygons round, which keep their first point, and leaves polygons out that are there more
 * than once (RepeatedFaces.h). The strips of a leaf in which something is
 * turned become triangles, each with the cell data of its strip. Points, point data, cell data and
 * all other cells stay as they are, and a leaf in which nothing changes is the one that came in.
 * Ghost cells are not looked at, and stay.
 *
 * Points up to `weldTolerance` from each other are one for this. Throws Refusal if all triangles
 * are unusable, and Interrupted.
 */
OrientedPolygons orientPolygons(const std::vector<vtkSmartPointer<vtkPolyData>>& leaves,
  double weldTolerance, Executor& executor);

} // namespace winding
