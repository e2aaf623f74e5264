// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "source/Grid.h"

#include "base/Digits.h"
#include "base/Refusal.h"

#include <cmath>
#include <limits>

namespace winding
{

namespace
{

void checkBounds(const Bounds& bounds)
{
  const Eigen::Vector3d &low = bounds.min(), &high = bounds.max();
  if (!low.allFinite() || !high.allFinite() || (low.array() > high.array()).any() ||
      !(high - low).allFinite())
  {
    throw Refusal(Message("the bounds are inverted or not finite",
      {{"give min <= max for each axis", {Parameter::samplingBounds}}},
      joined(
        "they are ", low[0], " ", high[0], " ", low[1], " ", high[1], " ", low[2], " ", high[2])));
  }
}

/// The most voxels of an axis: one less than the largest int, so that the corners of voxels
/// can be counted, too.
constexpr int mostVoxels = std::numeric_limits<int>::max() - 1;

/// The number of voxels of the given size that cover a length, at least one.
int countVoxels(double length, double voxelSize)
{
  // A length that is a multiple of the size up to rounding must not gain a voxel by that rounding.
  const double exact = length / voxelSize;
  const double count = std::max(1.0, std::ceil(exact * (1 - 1e-12)));
  if (!(count <= mostVoxels))
  {
    throw Refusal(Message("too many voxels", {largerVoxels()},
      joined("a side of ", length, " needs ", count, " voxels of size ", voxelSize, ", more than ",
        mostVoxels)));
  }
  return static_cast<int>(count);
}

/// Returns the margin on each side: the padding, or a voxel if that is more.
Eigen::Vector3d marginOf(const GridRequest& request)
{
  const Eigen::Array3d own = request.bounds.sizes().array();
  const double longest = own.maxCoeff();
  const bool hasDimensions = request.dimensions != Eigen::Vector3i::Zero();
  const bool isCubic = request.isCubic || !hasDimensions;
  Eigen::Array3d margin = Eigen::Array3d::Constant(longest * request.padding);
  if (!isCubic)
  {
    margin = request.padding * (own > 0).select(own, longest);
  }
  if (request.padding == 0)
  {
    return margin;
  }
  Eigen::Array3d voxels = Eigen::Array3d::Constant(request.voxelSize);
  if (hasDimensions || !(request.voxelSize > 0))
  {
    const Eigen::Vector3i counts =
      hasDimensions ? request.dimensions : Eigen::Vector3i::Constant(request.resolution);
    const Eigen::Array3d inner = counts.cast<double>().array() - 2;
    voxels = (inner > 0).select(own * inner.inverse(), 0);
  }
  return margin.max(isCubic ? Eigen::Array3d::Constant(voxels.maxCoeff()) : voxels);
}

void checkSampleCount(const Grid& grid)
{
  const double samples = grid.dimensions.cast<double>().prod();
  if (samples > 9e18)
  {
    throw Refusal(Message("too many voxels to be counted", {largerVoxels()},
      joined("the grid has ", grid.dimensions[0], " x ", grid.dimensions[1], " x ",
        grid.dimensions[2])));
  }
}

/// Checks that products of three lengths stay in the range of double.
void checkRange(const Grid& grid)
{
  constexpr double smallestVoxel = 1e-110, farthest = 1e102;
  const Eigen::Vector3d sides = grid.dimensions.cast<double>().cwiseProduct(grid.spacing);
  const Eigen::Vector3d low = grid.firstSample - 0.5 * grid.spacing;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(grid.spacing[axis] >= smallestVoxel))
    {
      throw Refusal(
        Message("the voxels are too small", {largerVoxels(), {"scale the source up", {}}},
          joined("they have a side of ", grid.spacing[axis], ", and it must be ", smallestVoxel,
            " at least")));
    }
    for (const double face : {low[axis], low[axis] + sides[axis]})
    {
      if (!(std::abs(face) <= farthest))
      {
        throw Refusal(Message("the grid reaches too far", {{"scale the source down", {}}},
          joined("it reaches to ", face, ", and it may reach to ", farthest, " at most")));
      }
    }
  }
}

} // namespace

std::size_t sampleCount(const Extent& extent)
{
  std::size_t count = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const long long length = static_cast<long long>(extent[2 * axis + 1]) - extent[2 * axis] + 1;
    count *= length > 0 ? static_cast<std::size_t>(length) : 0;
  }
  return count;
}

std::size_t sampleNumber(const Extent& extent, int i, int j, int k)
{
  const auto nx = static_cast<std::size_t>(extent[1] - extent[0] + 1);
  const auto ny = static_cast<std::size_t>(extent[3] - extent[2] + 1);
  return (static_cast<std::size_t>(k - extent[4]) * ny + static_cast<std::size_t>(j - extent[2])) *
           nx +
         static_cast<std::size_t>(i - extent[0]);
}

std::size_t sampleNumber(const Extent& extent, const Eigen::Vector3i& index)
{
  return sampleNumber(extent, index[0], index[1], index[2]);
}

Eigen::Vector3i sampleIndex(const Extent& extent, std::size_t n)
{
  const std::size_t nx = static_cast<std::size_t>(extent[1] - extent[0] + 1);
  const std::size_t ny = static_cast<std::size_t>(extent[3] - extent[2] + 1);
  return {extent[0] + static_cast<int>(n % nx), extent[2] + static_cast<int>(n / nx % ny),
    extent[4] + static_cast<int>(n / nx / ny)};
}

Eigen::Vector3d Grid::sample(std::size_t n) const
{
  return this->sample(this->wholeExtent(), n);
}

Eigen::Vector3d Grid::sample(const Extent& extent, std::size_t n) const
{
  return this->sample(sampleIndex(extent, n));
}

Grid setUpGrid(const GridRequest& request)
{
  checkBounds(request.bounds);
  if (!(request.padding >= 0) || !std::isfinite(request.padding))
  {
    throw Refusal(
      Message(Parameter::padding, joined("is ", request.padding, "; it must be 0 or more")));
  }
  if (!(request.voxelSize >= 0) || !std::isfinite(request.voxelSize))
  {
    throw Refusal(Message(Parameter::voxelSize,
      joined("is ", request.voxelSize, "; it must be 0 (from resolution) or more")));
  }
  const double longest = request.bounds.sizes().maxCoeff();
  const Eigen::Vector3d margin = marginOf(request);
  const Bounds padded(request.bounds.min() - margin, request.bounds.max() + margin);
  checkBounds(padded);
  const Eigen::Vector3d sides = padded.sizes();

  Grid grid;
  if (request.dimensions != Eigen::Vector3i::Zero())
  {
    if ((request.dimensions.array() < 1).any() || (request.dimensions.array() > mostVoxels).any())
    {
      throw Refusal(Message(Parameter::samplingDimensions,
        joined("is ", request.dimensions[0], " ", request.dimensions[1], " ", request.dimensions[2],
          "; each must be at least 1 and at most ", mostVoxels)));
    }
    if (!((request.isCubic ? longest : sides.minCoeff()) > 0))
    {
      throw Refusal(Message("the bounds are too flat for given dimensions",
        {{"give larger ones", {Parameter::samplingBounds}},
          {"give a padding", {Parameter::padding}}},
        joined("they have sides ", sides[0], " ", sides[1], " ", sides[2],
          ", and each must be more than 0")));
    }
    grid.dimensions = request.dimensions;
    grid.spacing = sides.cwiseQuotient(grid.dimensions.cast<double>());
    if (request.isCubic)
    {
      grid.spacing.setConstant(grid.spacing.maxCoeff());
    }
  }
  else
  {
    if (request.voxelSize == 0 && request.resolution < 1)
    {
      throw Refusal(Message(
        Parameter::resolution, joined("is ", request.resolution, "; it must be at least 1")));
    }
    if (request.voxelSize == 0 && !(longest > 0))
    {
      throw Refusal(Message(
        "the bounds are a single point", {{"give a voxel size", {Parameter::voxelSize}},
                                           {"give larger bounds", {Parameter::samplingBounds}}}));
    }
    const double size =
      request.voxelSize > 0 ? request.voxelSize : sides.maxCoeff() / request.resolution;
    grid.spacing.setConstant(size);
    for (int axis = 0; axis < 3; ++axis)
    {
      grid.dimensions[axis] = countVoxels(sides[axis], size);
    }
  }
  // Cubic voxels reach over both sides by the same amount; given dimensions fill the box exactly.
  const Eigen::Vector3d excess =
    request.dimensions != Eigen::Vector3i::Zero() && !request.isCubic
      ? Eigen::Vector3d(Eigen::Vector3d::Zero())
      : Eigen::Vector3d(grid.dimensions.cast<double>().cwiseProduct(grid.spacing) - sides);
  grid.firstSample = padded.min() - 0.5 * excess + 0.5 * grid.spacing;
  checkGrid(grid);
  return grid;
}

void checkGrid(const Grid& grid)
{
  checkSampleCount(grid);
  checkRange(grid);
  const Eigen::Vector3d steps = (grid.dimensions - Eigen::Vector3i::Ones()).cast<double>();
  const Eigen::Vector3d last = grid.firstSample + steps.cwiseProduct(grid.spacing);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (grid.dimensions[axis] > 1 &&
        !(grid.firstSample[axis] + grid.spacing[axis] > grid.firstSample[axis] &&
          last[axis] - grid.spacing[axis] < last[axis]))
    {
      throw Refusal(Message("the voxels are too far from the origin",
        {{"move the data towards it", {}}, largerVoxels()},
        joined("voxels of size ", grid.spacing[axis], " cannot be told apart at coordinate ",
          grid.firstSample[axis], " in double precision")));
    }
  }
}

} // namespace winding
