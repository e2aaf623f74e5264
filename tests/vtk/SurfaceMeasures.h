// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkType.h"
#include "vtkWindingABINamespace.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkPolyData;
class vtkWindingNumberGridAlgorithm;
class vtkWindingNumberSurface;
VTK_ABI_NAMESPACE_END

/// @file Measures of smooth surfaces, for tests.

struct EdgeCounts
{
  vtkIdType open, nonManifold;
};

EdgeCounts countEdges(vtkPolyData* surface);

/// The signed volume, more than 0 for a closed surface whose triangles face outward.
double signedVolume(vtkPolyData* surface);

vtkIdType countDuplicatePoints(vtkPolyData* surface);

/// The longest side of a voxel.
double voxelOf(vtkWindingNumberGridAlgorithm* filter);

/// The distances of the surface's points from the mesh, in voxels, ascending.
std::vector<double> distances(vtkPolyData* surface, vtkPolyData* mesh, double voxel);

/// Counts vertices at which w is neither the level nor jumps over it within a thousandth of a voxel
/// along an axis; less than twice `most` vertices are looked at.
int countOffLevel(
  vtkWindingNumberSurface* filter, vtkDataObject* source, vtkIdType most, double tolerance);
