// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkType.h"
#include "vtkWindingABINamespace.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkHyperTreeGrid;
class vtkWindingNumberGridAlgorithm;
VTK_ABI_NAMESPACE_END

/// The leaf of a hyper tree grid that each voxel of a filter's grid lies in, along x first, then y,
/// then z, found by the places of the cells; −1 where the voxel lies in none that is not masked.
/// Expects that cells are as large as voxels are or larger by powers of two, and that none overlap
/// or reach beyond the grid.
std::vector<vtkIdType> leavesOfVoxels(
  vtkHyperTreeGrid* trees, const vtkWindingNumberGridAlgorithm* filter);
