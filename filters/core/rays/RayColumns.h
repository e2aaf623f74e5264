// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/BucketSort.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

/**
 * @file
 * Rays along +x and triangles as they are seen along the rays: points and triangles in the plane of
 * y and z, in the columns of a grid over the rays.
 */
namespace winding
{

/// A sample in scaled coordinates (RayCounter), and the sum of the crossings that were found so
/// far.
struct Ray
{
  double x, y, z;
  std::size_t sample;
  int crossings;

  Eigen::Vector3d start() const { return {x, y, z}; }
};

/// The sides of a triangle's box that decide whether rays along +x may cross it.
struct TriangleBox
{
  TriangleBox(
    const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, double scale)
    : lowY(scale * std::min(std::min(a[1], b[1]), c[1]))
    , highY(scale * std::max(std::max(a[1], b[1]), c[1]))
    , lowZ(scale * std::min(std::min(a[2], b[2]), c[2]))
    , highZ(scale * std::max(std::max(a[2], b[2]), c[2]))
    , highX(scale * std::max(std::max(a[0], b[0]), c[0]))
  {
  }

  double lowY, highY, lowZ, highZ, highX;
};

/// The box of rays in y and z, across them, and the lowest x at which one of them starts.
struct RayBox
{
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = Eigen::Vector2d::Constant(-std::numeric_limits<double>::infinity());
  double firstX = std::numeric_limits<double>::infinity();

  RayBox() = default;
  RayBox(const Ray* first, const Ray* last)
  {
    for (; first != last; ++first)
    {
      this->add(first->start());
    }
  }

  void add(const Eigen::Vector3d& start)
  {
    low = low.cwiseMin(start.tail<2>());
    high = high.cwiseMax(start.tail<2>());
    firstX = std::min(firstX, start[0]);
  }

  void add(const RayBox& other)
  {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
    firstX = std::min(firstX, other.firstX);
  }

  bool isEmpty() const { return !(low[0] <= high[0]); }

  /// Whether all rays lie on the same line.
  bool isLine() const { return low == high; }

  /// Whether a triangle in a box may be crossed. Rays at its highest y or z pass it, for they count
  /// as moved upwards by infinitesimal steps.
  bool isReachedBy(const TriangleBox& box) const
  {
    return (box.lowY <= high[0]) & (box.highY > low[0]) & (box.lowZ <= high[1]) &
           (box.highZ > low[1]) & (box.highX >= firstX);
  }
};

/// The columns of a grid from the first to the last in y, and in z. Columns of the same z form a
/// row.
struct ColumnRange
{
  std::uint16_t firstY, lastY, firstZ, lastZ;

  static ColumnRange none() { return {1, 0, 1, 0}; }
  bool isEmpty() const { return firstY > lastY || firstZ > lastZ; }

  std::size_t size() const
  {
    return (std::size_t(lastY) + 1 - firstY) * (std::size_t(lastZ) + 1 - firstZ);
  }

  /// Whether these are so few columns that the box of a triangle is as good as its footprint.
  bool isNarrow() const { return this->size() <= 16; }
};

/**
 * A grid over a box of rays. Places are rounded, but never fall as a coordinate rises: all columns
 * that a triangle overlaps are between the columns of its corners.
 */
class Columns
{
public:
  /// Makes about `wanted` columns, at least 1 and at most mostBuckets. There are two or more if the
  /// box is no line and two are wanted, unless the box is so thin (1e-305) that a double cannot
  /// tell how thin.
  Columns(const RayBox& box, std::size_t wanted)
    : low_(box.low)
  {
    wanted = std::min(wanted, mostBuckets);
    const int most = static_cast<int>(wanted);
    const bool areBoth = isDivisible(box, 0, most) && isDivisible(box, 1, most);
    const int root = static_cast<int>(std::sqrt(static_cast<double>(wanted)));
    const int perAxis = areBoth ? std::max(std::min(2, most), root) : most;
    for (int axis = 0; axis < 2; ++axis)
    {
      const bool isDivided = isDivisible(box, axis, perAxis);
      count_[axis] = isDivided ? perAxis : 1;
      const double undivided = box.high[axis] > box.low[axis] ? 0 : inPlane;
      scale_[axis] = isDivided ? perAxis / (box.high[axis] - box.low[axis]) : undivided;
    }
  }

  std::size_t count() const
  {
    return static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]);
  }
  /// The number of columns in a row.
  std::size_t perRow() const { return static_cast<std::size_t>(count_[0]); }

  std::size_t number(int y, int z) const
  {
    return static_cast<std::size_t>(z) * this->perRow() + static_cast<std::size_t>(y);
  }
  std::size_t of(const Eigen::Vector3d& start) const
  {
    return this->number(
      this->place(0, this->inUnits(0, start[1])), this->place(1, this->inUnits(1, start[2])));
  }

  ColumnRange of(const TriangleBox& box) const
  {
    const auto place = [this](int axis, double coordinate)
    {
      return static_cast<std::uint16_t>(this->place(axis, this->inUnits(axis, coordinate)));
    };
    return {place(0, box.lowY), place(0, box.highY), place(1, box.lowZ), place(1, box.highZ)};
  }

  /// A coordinate in units of columns: column i of an axis is from i to i + 1.
  double inUnits(int axis, double coordinate) const
  {
    return (coordinate - low_[axis]) * scale_[axis];
  }
  /// The column of an axis that a coordinate in units of columns is in; the nearest one for a
  /// coordinate outside the grid.
  int place(int axis, double inUnits) const
  {
    return inUnits >= count_[axis] ? count_[axis] - 1 : inUnits > 0 ? static_cast<int>(inUnits) : 0;
  }

private:
  /// The scale across rays that all lie in one plane: a column so thin (1e-9) that it cuts from
  /// triangles just their part in that plane.
  static constexpr double inPlane = 0x1p30;

  static bool isDivisible(const RayBox& box, int axis, int count)
  {
    const double scale = count / (box.high[axis] - box.low[axis]);
    return count > 1 && std::isfinite(scale) && scale > 0;
  }

  Eigen::Vector2d low_;
  double scale_[2];
  int count_[2];
};

/**
 * The columns that a triangle overlaps. None of them is left out, whatever the rounding, and other
 * columns are included only if they lie within rounding of the triangle. Columns are walked in
 * runs: the triangle covers one run of each row, or, where there are more rows than columns in a
 * row, one run across the rows.
 */
class Footprint
{
public:
  /// `range` covers the triangle's box, or the part of it that is asked for. Keeps a reference
  /// to the columns.
  Footprint(const Columns& columns, const ColumnRange& range, const Eigen::Vector3d& a,
    const Eigen::Vector3d& b, const Eigen::Vector3d& c)
    : columns_(columns)
    , range_(range)
    , areRows_(range.lastZ - range.firstZ <= range.lastY - range.firstY)
  {
    const int along = areRows_ ? 0 : 1;
    const Eigen::Vector3d* corners[3] = {&a, &b, &c};
    // Coordinates are u along the runs and v across them.
    double u[3], v[3], size = static_cast<double>(mostBuckets);
    for (int i = 0; i < 3; ++i)
    {
      u[i] = columns.inUnits(along, (*corners[i])[1 + along]);
      v[i] = columns.inUnits(1 - along, (*corners[i])[2 - along]);
      size = std::max({size, std::abs(u[i]), std::abs(v[i])});
    }
    // The places of corners and of rays are off by 2 roundings each, a cut by 11; the
    // margin is 32 roundings. The box must do for a triangle so much larger than columns that this
    // matters.
    margin_ = 16 * std::numeric_limits<double>::epsilon() * size;
    isCertain_ = margin_ < 0.25;
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const int from = v[i] < v[j] ? i : j, to = v[i] < v[j] ? j : i;
      if (v[from] < v[to]) // an edge along the runs ends where others end
      {
        const double slope = (u[to] - u[from]) / (v[to] - v[from]);
        isCertain_ = isCertain_ && std::isfinite(slope);
        edges_[count_++] = {v[from], v[to], u[from], slope};
      }
    }
    // A triangle in a single place across the runs has no edges that cut a row.
    isCertain_ = isCertain_ && count_ > 0;
  }

  /// Calls visit(column) for all columns.
  template <class Visit> void forEach(const Visit& visit) const
  {
    if (areRows_)
    {
      for (int z = range_.firstZ; z <= range_.lastZ; ++z)
      {
        const auto [first, last] = this->runIn(z, 0, range_.firstY, range_.lastY);
        for (int y = first; y <= last; ++y)
        {
          visit(columns_.number(y, z));
        }
      }
      return;
    }
    for (int y = range_.firstY; y <= range_.lastY; ++y)
    {
      const auto [first, last] = this->runIn(y, 1, range_.firstZ, range_.lastZ);
      for (int z = first; z <= last; ++z)
      {
        visit(columns_.number(y, z));
      }
    }
  }

private:
  /// An edge from its lower end across the runs to its higher one; `along` is the place of the
  /// lower end along the runs.
  struct Edge
  {
    double low, high, along, slope;
  };

  struct Run
  {
    int first, last;
  };

  Run runIn(int row, int axis, int first, int last) const
  {
    if (!isCertain_)
    {
      return {first, last};
    }
    const double lowest = row - margin_, highest = row + 1 + margin_;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (int i = 0; i < count_; ++i)
    {
      const Edge& edge = edges_[i];
      if (edge.high >= lowest && edge.low <= highest)
      {
        const double from = edge.along + (std::max(lowest, edge.low) - edge.low) * edge.slope;
        const double to = edge.along + (std::min(highest, edge.high) - edge.low) * edge.slope;
        low = std::min({low, from, to});
        high = std::max({high, from, to});
      }
    }
    if (!(low <= high))
    {
      return {0, -1};
    }
    return {std::max(first, columns_.place(axis, low - margin_)),
      std::min(last, columns_.place(axis, high + margin_))};
  }

  const Columns& columns_;
  ColumnRange range_;
  bool areRows_;
  Edge edges_[3];
  int count_ = 0;
  double margin_;
  bool isCertain_;
};

} // namespace winding
