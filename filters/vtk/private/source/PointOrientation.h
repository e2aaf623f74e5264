// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"

#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

#include <cstddef>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace winding
{

/// Clouds that are one source, with their normals oriented (ConsistentNormals.h).
struct OrientedPointSets
{
  std::vector<vtkSmartPointer<vtkPolyData>> leaves;
  std::size_t points = 0; ///< number of normals turned
};

/**
 * Turns normals round that disagree with the field of all points; their directions, lengths and
 * types stay, as do all other data, and a leaf in which nothing is turned is the one that came in.
 * Points whose position or normal is not finite, or whose normal has length 0, stay as they are.
 * normalsArray: the name of the array of normals, or none for the active normals.
 *
 * Throws Refusal where points have no normals, and Interrupted.
 */
OrientedPointSets orientNormals(const std::vector<vtkSmartPointer<vtkPolyData>>& leaves,
  const std::string& normalsArray, Executor& executor);

} // namespace winding
