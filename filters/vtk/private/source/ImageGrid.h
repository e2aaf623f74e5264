#pragma once

#include "source/Grid.h"

#include <optional>

class vtkDataSet;

namespace winding
{

/// The grid whose samples are the points of an image, or the centres of its cells, in their order.
/// Nothing for other data sets, for images that are turned or without samples, and for images that
/// no grid can be (checkGrid()). Where VTK adds up a point in another order, it differs by a
/// rounding.
std::optional<Grid> gridOfImage(vtkDataSet* data, bool atCells);

} // namespace winding
