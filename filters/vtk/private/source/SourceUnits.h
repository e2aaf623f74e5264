// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"

#include "vtkWindingABINamespace.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
VTK_ABI_NAMESPACE_END

namespace winding
{

/// Returns the box around the points of a data set, or of all leaves of a composite one; empty
/// without any. Points that are not finite are left out.
Bounds pointBoundsOf(vtkDataObject* data);

} // namespace winding
