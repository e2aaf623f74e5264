// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkFieldData;
class vtkMultiBlockDataSet;
VTK_ABI_NAMESPACE_END

namespace winding
{

class Executor;
class InputViews;
struct CellCounts;
struct FaultShape;
struct FieldOptions;
struct OrientedPolygons;

struct SourceReport
{
  /// The arrays of vtkWindingNumberReport, in the order in which people read them: counts are
  /// vtkIdType, yes or no is unsigned char, measures are double, words are strings.
  vtkSmartPointer<vtkFieldData> arrays;
  std::vector<std::string> advice; ///< what spoils most first, a text for each point
  /// The faults of a surface, to look at (FaultBlocks.h); a cloud has none.
  vtkSmartPointer<vtkMultiBlockDataSet> faults;
};

/// Makes the report on a source. `completion` has the mirror and the base of a surface. `cells`
/// counts the source's, and `fix` says how its polygons have been turned before: null if that was
/// not asked for. The core's exceptions pass through.
SourceReport reportOn(InputViews& source, const FieldOptions& completion, const FaultShape& shape,
  const CellCounts& cells, const OrientedPolygons* fix, Executor& executor);

} // namespace winding
