#pragma once

#include "vtkSmartPointer.h"

class vtkFieldData;
class vtkMultiBlockDataSet;

namespace winding
{

class Executor;
class InputViews;
struct OrientedPolygons;

struct SourceReport
{
  /// The arrays of vtkSurfaceReport, in the order in which people read them: counts as vtkIdType, yes
  /// or no as unsigned char, measures as double, words as strings.
  vtkSmartPointer<vtkFieldData> arrays;
  /// What is wrong with a surface, to look at (FaultBlocks.h); for a cloud the same blocks, empty.
  vtkSmartPointer<vtkMultiBlockDataSet> faults;
};

/// pointType: the VTK type of the faults' points. fix: what has been done to the polygons of the source
/// before, or null if that was not asked for. Throws what the core throws.
SourceReport reportOn(
  InputViews& source, int pointType, const OrientedPolygons* fix, Executor& executor);

} // namespace winding
