#pragma once

#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkPointSet;

namespace winding
{

/// Whether a data set has cells that bound something: of two dimensions or more.
bool hasFaces(vtkPointSet* leaf);

enum class SourceKind
{
  nothing,
  mesh,
  cloud
};

/// What a source is, whatever it is to be taken as: a mesh if any of its leaves has faces. Looks at no
/// array, and never throws: what is no source is nothing.
SourceKind kindOf(vtkDataObject* source);

/// Throws Refusal if a cell refers to a point that does not exist: vtkDataSetSurfaceFilter trusts the
/// ids of cells, and crashes on such.
void checkCellIds(vtkPointSet* leaf);

/**
 * What a data set has in its own right: cells and points that another piece of the data has too, or
 * that are hidden, would be counted twice or against the user's will. The data set itself if there
 * are none.
 */
vtkSmartPointer<vtkPointSet> withoutGhosts(vtkPointSet* leaf, bool isMesh);

} // namespace winding
