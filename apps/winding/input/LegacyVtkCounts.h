// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkWindingABINamespace.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkPointSet;
VTK_ABI_NAMESPACE_END

/// Throws Failure where the cells that came out of a legacy .vtk file are not as many as it
/// announces: where sizes of cells contradict their sum, VTK's reader reads on in memory that is
/// not its own.
void checkLegacyVtkCounts(const std::string& fileName, vtkPointSet* data);
