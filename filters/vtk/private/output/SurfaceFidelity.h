#pragma once

#include "base/Executor.h"
#include "field/Field.h"

#include <cstddef>

class vtkPolyData;

namespace winding
{

/// Compares a surface with the source of a field (Fidelity.h), and adds what is found to the field
/// data of the surface; vtkWindingNumberSurface says which arrays these are. Polygons are taken as
/// fans from their first corner. Throws Interrupted, and OutOfMemory as the next function does.
void addFidelity(
  const Field& field, double voxel, std::size_t samples, vtkPolyData* surface, Executor& executor);

/// Throws OutOfMemory if there is not enough memory to compare a surface of `triangles` triangles.
void refuseFidelityBeyondFreeMemory(const Field& field, double triangles, std::size_t samples);

} // namespace winding
