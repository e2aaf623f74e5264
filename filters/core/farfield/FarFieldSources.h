// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "base/Executor.h"
#include "farfield/SplitTriangles.h"
#include "source/PointCloud.h"
#include "source/Surface.h"
#include "sums/DirectSumKernels.h"
#include "sums/GradientKernels.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace winding
{

/// Items begin … end − 1.
struct ItemRange
{
  std::uint32_t begin, end;
};

/// The number of items in ranges.
inline std::size_t itemsIn(const std::vector<ItemRange>& ranges)
{
  std::size_t items = 0;
  for (const ItemRange& range : ranges)
  {
    items += range.end - range.begin;
  }
  return items;
}

/**
 * The sources of a far field: items that are summed exactly near by and are distributions of
 * dipoles far away. Coordinates are the caller's times `scale`, a power of two that brings
 * the sources to about unit size.
 */
class FarFieldSources
{
public:
  virtual ~FarFieldSources() = default;

  double scale() const { return scale_; }

  /// The centres of the items of the tree. Throws Interrupted.
  virtual std::vector<Eigen::Vector3d> centers(Executor& executor) const = 0;

  /// Whether an item stands before another one with an equal centre: by all of its numbers, so that
  /// items that stand in no order are equal. Valid until the items are arranged.
  virtual bool isBefore(std::uint32_t item, std::uint32_t other) const = 0;

  /// Items that together are the whole field, as few as can be: all points, or all triangles, with
  /// those that were cut as they were before. Valid once the items are arranged.
  const std::vector<ItemRange>& whole() const { return whole_; }

  /// The number of items in whole().
  std::size_t wholeSize() const { return wholeSize_; }

  /// Puts item order[i] at place i. inSingle: points may be summed in single precision, with
  /// offsets in double; triangles never are, as the last bits decide on which side a sample lies.
  /// Throws Interrupted, after which the sources are of no use.
  virtual void arrange(
    const std::vector<std::uint32_t>& order, bool inSingle, Executor& executor) = 0;

  struct Dipole
  {
    Eigen::Vector3d position;
    Eigen::Vector3d moment; ///< normal · area / 4π
  };

  /// Appends dipoles that have the moments of the items up to the given order, exactly.
  virtual void appendDipoles(ItemRange items, int order, std::vector<Dipole>& dipoles) const = 0;

  /// The farthest distance of any point of the items from a centre.
  virtual double reach(ItemRange items, const Eigen::Vector3d& center) const = 0;

  /// The largest length over which one of the items is spread (SolidAngle.h), 0 if none is. An
  /// item's value and gradient are the dipoles' that stand for it only several of its
  /// lengths away.
  virtual double spread(ItemRange items) const = 0;

  /**
   * Sums some items at a block of samples in scaled coordinates, exactly up to rounding. Triangles
   * set isSuspect[i], unless that is null, to whether sample i lies on one of them within rounding,
   * and return whether any sample does. Points return false and set nothing.
   */
  virtual bool sum(const std::vector<ItemRange>& items, const SampleBlock& samples, double* values,
    bool* isSuspect) const = 0;

  /// Adds the gradients of some items, exact up to rounding.
  virtual void addGradients(
    const std::vector<ItemRange>& items, const SampleBlock& samples, GradientSums& sums) const = 0;

  /// The approximate cost of one item at one sample.
  virtual double secondsPerPair() const = 0;

  /// The cost of eight cells beyond the cell that they are cut from, for each coefficient
  /// of an expansion: the figure with which grids and scattered samples take the least time. A sum
  /// of triangles has more to begin and to end.
  virtual double secondsPerCutAndCoefficient() const = 0;

  ///@{
  /// The approximate cost of a look at a node and, for the square of each coefficient of an
  /// expansion, of a node that acts through a cell's. A cell gives up where they come to too much:
  /// triangles of a soup are near to all cells. Points never are, so that theirs is 0.
  virtual double secondsPerLook() const { return 0; }
  virtual double secondsPerTranslation() const { return 0; }
  ///@}

  /// The number of items of a leaf with which grids and scattered samples take the least time. With
  /// fewer the tree takes more time to make than it saves.
  virtual std::size_t leafSize() const = 0;

protected:
  explicit FarFieldSources(double scale)
    : scale_(scale)
  {
  }

  void setWhole(std::vector<ItemRange> whole)
  {
    wholeSize_ = itemsIn(whole);
    whole_ = std::move(whole);
  }

private:
  double scale_;
  std::vector<ItemRange> whole_;
  std::size_t wholeSize_ = 0; ///< kept, since every cell of samples asks for it
};

/// The points of a cloud, spread over its regularization lengths, if it has any.
/// Throws Interrupted.
std::unique_ptr<FarFieldSources> farFieldSources(
  const PointCloud& cloud, const std::vector<double>& areas, Executor& executor);

/// The triangles of a surface; those with sides longer than the rule allows are cut in pieces
/// first. Throws Interrupted.
std::unique_ptr<FarFieldSources> farFieldSources(const std::vector<Eigen::Vector3d>& vertices,
  const ChainView& triangles, const Bounds& bounds, const SplitRule& rule, Executor& executor);

} // namespace winding
