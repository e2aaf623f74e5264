// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWindingABINamespace.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkCellArray;
class vtkTypeInt64Array;
VTK_ABI_NAMESPACE_END

namespace winding
{

/// Makes cells of `size` points each, which are `ids` one after the other.
vtkSmartPointer<vtkCellArray> cellsOf(vtkTypeInt64Array* ids, vtkIdType size);

} // namespace winding
