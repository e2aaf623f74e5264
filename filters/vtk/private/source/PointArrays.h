// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkWindingABINamespace.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkPointSet;
VTK_ABI_NAMESPACE_END

namespace winding
{

/// The point data array with a name, or the active normals for no name. Null where no name was
/// given and there are no active normals. Throws Refusal where no array has the name, and where the
/// array has another number of components or too few values.
vtkDataArray* pointArray(vtkPointSet* points, const std::string& name, int components);

/// The normals of points by the property NormalsArray: an array's name, or none for the active
/// normals. Otherwise as pointArray().
vtkDataArray* normalsOf(vtkPointSet* points, const std::string& name);

} // namespace winding
