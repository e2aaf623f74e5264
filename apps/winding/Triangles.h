#pragma once

#include "base/Views.h"

#include <cstdint>
#include <vector>

class vtkPointSet;

/// Coordinates and triangles of a data set, copied out of VTK in double precision.
struct Triangles
{
  std::vector<double> coordinates;
  std::vector<std::int64_t> ids;

  std::size_t points() const { return coordinates.size() / 3; }
  std::size_t triangles() const { return ids.size() / 3; }
  winding::TrianglesView view() const;
};

/**
 * Polygons as fans from their first vertex and strips unrolled, as the filters take them; other
 * cells through their outer surface. No triangles for clouds.
 */
Triangles trianglesOf(vtkPointSet* data);
