// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/source/ImageGrid.h"

#include "base/Refusal.h"
#include "private/source/CellChecks.h"
#include "tasks/Sentences.h"

#include "vtkImageData.h"
#include "vtkMatrix3x3.h"

#include <cmath>

namespace winding
{

namespace
{

/// The directions in which the indices of an image grow, as columns.
Eigen::Matrix3d axesOf(vtkImageData* image)
{
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  Eigen::Matrix3d axes = Eigen::Map<const RowMajor>(image->GetDirectionMatrix()->GetData());
  for (int axis = 0; axis < 3; ++axis)
  {
    if (image->GetSpacing()[axis] < 0)
    {
      axes.col(axis) *= -1;
    }
  }
  return axes;
}

/// Lays a grid on an image that has samples and right angles, as requiredGridOf() says.
ImageGrid layOn(vtkImageData* image, bool atCells, bool areVoxels)
{
  ImageGrid result;
  Eigen::Vector3d start(image->GetOrigin());
  const Eigen::Matrix3d axes = axesOf(image);
  if (axes != Eigen::Matrix3d::Identity())
  {
    result.frame = ImageFrame(axes, start);
    start.setZero();
  }
  Grid& grid = result.grid;
  const int* const extent = image->GetExtent();
  grid.spacing = Eigen::Vector3d(image->GetSpacing()).cwiseAbs();
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.firstSample[axis] = start[axis] + extent[2 * axis] * grid.spacing[axis];
    grid.dimensions[axis] = extent[2 * axis + 1] - extent[2 * axis] + 1;
    if (atCells && grid.dimensions[axis] > 1)
    {
      grid.firstSample[axis] += 0.5 * grid.spacing[axis];
      --grid.dimensions[axis];
    }
  }
  // A layer of points has no thickness, and one of voxels may have none.
  const Eigen::Array<bool, 3, 1> isLayer = grid.dimensions.array() == 1;
  const double widest = isLayer.select(0, grid.spacing).maxCoeff();
  const double none = areVoxels ? 0 : HUGE_VAL;
  const Eigen::Array<bool, 3, 1> isThin = isLayer && !(grid.spacing.array() > none);
  grid.spacing = isThin.select(widest > 0 ? widest : 1, grid.spacing);
  return result;
}

} // namespace

bool hasRightAngles(vtkImageData* image, double skew)
{
  const Eigen::Matrix3d axes = axesOf(image);
  const Eigen::Matrix3d products = axes.transpose() * axes - Eigen::Matrix3d::Identity();
  return (products.array().abs() <= skew).all(); // and none is NaN
}

ImageGrid requiredGridOf(vtkImageData* image, bool atCells, bool areVoxels)
{
  checkStructure(image, "the image to lie on");
  if (image->GetNumberOfPoints() == 0)
  {
    throw Refusal(messageOf(Sentence::imageIsEmpty));
  }
  if (!hasRightAngles(image, mostSkewToLieOn))
  {
    throw Refusal(messageOf(Sentence::imageIsSkew));
  }
  const ImageGrid result = layOn(image, atCells, areVoxels);
  checkGrid(result.grid);
  return result;
}

std::optional<ImageGrid> gridOfImage(vtkDataSet* data, bool atCells)
{
  auto* image = vtkImageData::SafeDownCast(data);
  if (!image || image->GetNumberOfPoints() == 0 || !hasRightAngles(image, mostSkew))
  {
    return std::nullopt;
  }
  const ImageGrid result = layOn(image, atCells, false);
  try
  {
    checkGrid(result.grid);
  }
  catch (const Refusal&)
  {
    return std::nullopt; // its samples are scattered points
  }
  return result;
}

} // namespace winding
