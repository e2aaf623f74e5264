#pragma once

#include "private/source/ImageFrame.h"
#include "source/Grid.h"

#include <optional>

class vtkDataSet;
class vtkImageData;

namespace winding
{

/// A grid in the coordinates of an image.
struct ImageGrid
{
  Grid grid;
  ImageFrame frame;
};

/// The largest difference from 0 or 1 that products of two axes of an image may have. Directions in
/// single precision, as NIfTI keeps them, or with six digits are within it.
constexpr double mostSkew = 1e-5;

/// Whether the axes of an image are at right angles, so that it has an ImageFrame in which
/// distances are what they are in space, up to mostSkew.
bool hasRightAngles(vtkImageData* image);

/// The grid whose samples are the points of an image, or the centres of its cells, in their order.
/// Its frame is the space's if the image is neither turned nor has negative spacings, and the
/// image's own otherwise. Nothing for other data sets, for images with axes that are not at right
/// angles or without samples, and for images that no grid can be (checkGrid()). Where VTK adds up a
/// point in another order, it differs by a rounding.
std::optional<ImageGrid> gridOfImage(vtkDataSet* data, bool atCells);

/// The same for an image that a grid is to lie on. Throws Refusal where there is no grid, with the
/// reason.
ImageGrid requiredGridOf(vtkImageData* image, bool atCells);

} // namespace winding
