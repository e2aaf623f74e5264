// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace winding
{

/// A box of samples of a grid, as inclusive index ranges {i0, i1, j0, j1, k0, k1}.
using Extent = std::array<int, 6>;

/**
 * A grid of voxels; the samples are their centres. Sample (i, j, k) lies at
 * firstSample + (i, j, k)·spacing, computed in this way for every caller, so that any part of the
 * grid has the very positions that the whole has.
 */
struct Grid
{
  Eigen::Vector3d firstSample = Eigen::Vector3d::Zero();
  Eigen::Vector3d spacing = Eigen::Vector3d::Ones();
  Eigen::Vector3i dimensions = Eigen::Vector3i::Zero(); ///< voxels per axis

  /// The corner of the first voxel, half a voxel before the first sample.
  Eigen::Vector3d corner() const { return firstSample - 0.5 * spacing; }

  Eigen::Vector3d sample(int i, int j, int k) const
  {
    return firstSample + Eigen::Vector3d(i, j, k).cwiseProduct(spacing);
  }

  Eigen::Vector3d sample(const Eigen::Vector3i& index) const
  {
    return this->sample(index[0], index[1], index[2]);
  }

  ///@{
  /// The position of sample number n of the whole grid, or of an extent of it, as sampleIndex()
  /// numbers them.
  Eigen::Vector3d sample(std::size_t n) const;
  Eigen::Vector3d sample(const Extent& extent, std::size_t n) const;
  ///@}

  /// A position in units of sample indices: sample (i, j, k) has the coordinates i, j, k.
  Eigen::Vector3d inGridUnits(const Eigen::Vector3d& position) const
  {
    return (position - firstSample).cwiseQuotient(spacing);
  }

  /// A coordinate of inGridUnits(), with the same bits.
  double inGridUnits(const Eigen::Vector3d& position, int axis) const
  {
    return (position[axis] - firstSample[axis]) / spacing[axis];
  }

  Extent wholeExtent() const
  {
    return {0, dimensions[0] - 1, 0, dimensions[1] - 1, 0, dimensions[2] - 1};
  }
};

/// The first and the last index along an axis; the range is empty if the first is the larger one.
using IndexRange = std::pair<int, int>;

/// The indices from `first` to `last`, which are 0 or more, that lie between two coordinates in
/// grid units.
inline IndexRange indicesBetween(double low, double high, int first, int last)
{
  if (!(high >= first && low <= last))
  {
    return {0, -1};
  }
  // The casts below round down, as both numbers are 0 or more.
  const double from = std::max<double>(low, first), to = std::min<double>(high, last);
  const int whole = static_cast<int>(from);
  return {whole + (whole < from), static_cast<int>(to)};
}

/// The number of samples in an extent; 0 if any range is empty.
std::size_t sampleCount(const Extent& extent);

///@{
/// The number of a sample in its extent: numbers begin at 0 and i runs fastest.
std::size_t sampleNumber(const Extent& extent, int i, int j, int k);
std::size_t sampleNumber(const Extent& extent, const Eigen::Vector3i& index);
///@}

/// The indices of sample number n of an extent: numbers begin at 0 and i runs fastest.
Eigen::Vector3i sampleIndex(const Extent& extent, std::size_t n);

/// A user's wishes for a grid.
struct GridRequest
{
  Bounds bounds; ///< the box to cover: the source's, or the user's own
  /// Margin on each side, as a fraction of the longest side. Where voxels are not cubic, it is a
  /// fraction of each axis's own side, unless that is 0. It is a voxel at least if it is not 0 and
  /// three voxels or more are given.
  double padding = 0;
  Eigen::Vector3i dimensions = Eigen::Vector3i::Zero(); ///< voxels per axis; 0 0 0: cubic voxels
  bool isCubic = false; ///< whether voxels are cubic even where dimensions are given
  double voxelSize = 0; ///< side of the cubic voxels; 0: follows from resolution
  int resolution = 128; ///< number of cubic voxels along the longest side
};

/**
 * Lays a grid over the bounds. A grid of given dimensions fills the padded bounds exactly; cubic
 * voxels may reach over them, by the same amount on both sides, and by a voxel in all at most where
 * no dimensions are given. Throws Refusal for sizes, bounds or paddings that make no grid, with the
 * numbers, and for voxels smaller than 1e-110 or farther than 1e102 from the origin, so that
 * products of three lengths stay in the range of double.
 */
Grid setUpGrid(const GridRequest& request);

/// Throws Refusal for a grid that setUpGrid() would not make: for its size, its place, or samples
/// that cannot be told apart.
void checkGrid(const Grid& grid);

} // namespace winding
