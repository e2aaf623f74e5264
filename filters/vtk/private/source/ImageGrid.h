// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "private/source/ImageFrame.h"
#include "source/Grid.h"

#include "vtkWindingABINamespace.h"

#include <optional>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace winding
{

/// A grid in the coordinates of an image.
struct ImageGrid
{
  Grid grid;
  ImageFrame frame;
};

///@{
/// The largest difference from 0 or 1 that products of two axes of an image may have: in a grid of
/// queries, and where a result is to lie on the image. Directions in single precision, as NIfTI
/// keeps them, or with six digits are within the first, and with four digits within the second.
/// Samples lie at the places of the image in any case. Distances have that relative error.
constexpr double mostSkew = 1e-5;
constexpr double mostSkewToLieOn = 1e-3;
///@}

/// Whether the axes of an image are at right angles up to a skew, so that it has an ImageFrame in
/// which distances are what they are in space.
bool hasRightAngles(vtkImageData* image, double skew);

/// The grid whose samples are the points of an image, or the centres of its cells, in their order.
/// Its frame is the space's if the image is neither turned nor has negative spacings, and the
/// image's own otherwise. Nothing for other data sets, for images with axes that are not at right
/// angles up to mostSkew or without samples, and for images that no grid can be (checkGrid()).
/// Where VTK adds up a point in another order, it differs by a rounding.
std::optional<ImageGrid> gridOfImage(vtkDataSet* data, bool atCells);

/// The same for an image that a grid is to lie on, up to mostSkewToLieOn. A single layer of samples
/// has the spacing of the image across it where `areVoxels`, and as points the widest one in it.
/// Throws Refusal where there is no grid, with the reason.
ImageGrid requiredGridOf(vtkImageData* image, bool atCells, bool areVoxels);

} // namespace winding
