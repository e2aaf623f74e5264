#pragma once

#include "vtkType.h"

#include <vector>

class vtkDataObject;
class vtkPolyData;
class vtkWindingNumberSurface;

/// @file What tests ask of a smooth surface.

struct EdgeCounts
{
  vtkIdType open, nonManifold;
};

EdgeCounts countEdges(vtkPolyData* surface);

/// More than 0 for a closed surface whose triangles face outward.
double signedVolume(vtkPolyData* surface);

vtkIdType countDuplicatePoints(vtkPolyData* surface);

/// The longest side of a voxel.
double voxelOf(vtkWindingNumberSurface* filter);

/// How far the points of one are from the other, in voxels, ascending.
std::vector<double> distances(vtkPolyData* surface, vtkPolyData* mesh, double voxel);

/// Vertices, at most `most` of them, at which w is neither the level nor jumps over it within a
/// thousandth of a voxel along an axis.
int countOffLevel(
  vtkWindingNumberSurface* filter, vtkDataObject* source, vtkIdType most, double tolerance);
