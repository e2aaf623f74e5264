// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "field/Field.h"
#include "report/Fidelity.h"

#include "vtkWindingABINamespace.h"

#include <cstddef>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace winding
{

/// Adds the array "DistanceToInput" to the points of a surface, as active scalars: their distances
/// from the source of a field, in the precision of the points. Throws Interrupted.
void addDistances(const Field& field, vtkPolyData* surface, Executor& executor);

/// Compares a surface with the source of a field, adds what is found to the field data of the
/// surface, and returns it. vtkWindingNumberSurface says which arrays these are. Polygons are taken
/// as fans from their first corner. Throws Interrupted, and OutOfMemory as the next function does.
Fidelity addFidelity(const Field& field, double voxel, std::size_t samples,
  const WantedDistances* wanted, vtkPolyData* surface, Executor& executor);

/// Throws OutOfMemory if there is not enough memory to compare a surface of `triangles` triangles.
void refuseFidelityBeyondFreeMemory(const Field& field, double triangles, std::size_t samples);

} // namespace winding
