// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkInformation;
class vtkMultiBlockDataSet;
class vtkPointSet;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace winding
{

struct CellCounts;

/// Whether a data set has cells that bound something: of two dimensions or more.
bool hasFaces(vtkPointSet* leaf);

/// Returns whether most cells of a data set are of one dimension, and none bounds anything. Their
/// types are known.
bool isOfLines(vtkPointSet* leaf);

enum class SourceKind
{
  nothing,
  mesh,
  cloud
};

/// The kind of a source, even if it is to be taken as another: a mesh if any of its leaves has
/// faces. Data that is no source is `nothing`. The function looks at no array, and never throws.
SourceKind kindOf(vtkDataObject* source);

/**
 * Returns the part of a leaf that is its own: of a mesh ownCellsOf(), of a cloud the points that no
 * other piece of the data has and that are not hidden. Returns the leaf itself if that is all of
 * it. Throws Refusal, about data of that name, where it is not and cells cannot be followed
 * (CellChecks.h).
 */
vtkSmartPointer<vtkPointSet> ownPartOf(
  vtkPointSet* leaf, bool takesFaces, const std::string& name, CellCounts& counts);

/**
 * The leaves of a source, of the kinds that InputViews takes, as polydata: polydata as it is, other
 * meshes as their outer surface (OuterSurface.h), other clouds as points with a vertex cell each.
 * Next to a surface meshes of lines stay lines, which are counted. A source that is no composite is
 * its own leaf. The cells of other meshes were checked (CellChecks.h).
 */
std::vector<vtkSmartPointer<vtkPolyData>> leavesAsPolyData(
  vtkDataObject* source, bool takesFaces, CellCounts& counts);

/// Leaves appended to each other, with the arrays that all have.
vtkSmartPointer<vtkPolyData> appended(const std::vector<vtkSmartPointer<vtkPolyData>>& leaves);

/// Leaves as one composite source.
vtkSmartPointer<vtkMultiBlockDataSet> asBlocks(
  const std::vector<vtkSmartPointer<vtkPolyData>>& leaves);

/// Asks upstream for a piece of a source, whatever piece of the result was asked for; for all of it
/// unless there are several pieces.
void requestPiece(vtkInformation* source, int piece, int pieces);

} // namespace winding
