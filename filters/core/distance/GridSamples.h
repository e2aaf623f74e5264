// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "source/Grid.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace winding
{

/// Whether an extent has no sample.
inline bool isEmpty(const Extent& extent)
{
  return extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5];
}

/// Returns what two extents have in common.
inline Extent common(const Extent& a, const Extent& b)
{
  Extent both;
  for (int axis = 0; axis < 3; ++axis)
  {
    both[2 * axis] = std::max(a[2 * axis], b[2 * axis]);
    both[2 * axis + 1] = std::min(a[2 * axis + 1], b[2 * axis + 1]);
  }
  return both;
}

/// Returns the position of a sample of a grid in scaled coordinates.
inline Eigen::Vector3d scaledSample(const Grid& grid, int i, int j, int k, double scale)
{
  const Eigen::Vector3d position = grid.sample(i, j, k);
  return {scaledCoordinate(position[0], scale), scaledCoordinate(position[1], scale),
    scaledCoordinate(position[2], scale)};
}

/// The samples of a grid as CellDescent.h wants them: a part is an extent. A class that inherits
/// writes what is found.
class GridSamples
{
public:
  using Part = Extent;
  using Name = std::size_t; ///< its number in the output

  GridSamples(const Grid& grid, const Extent& asked, double scale)
    : grid_(grid)
    , asked_(asked)
    , scale_(scale)
  {
  }

  static std::size_t count(const Extent& part) { return sampleCount(part); }

  bool isAskedFor(const Extent& part) const { return !isEmpty(common(part, asked_)); }

  Bounds boxOf(const Extent& part) const
  {
    return {
      this->positionOf(part[0], part[2], part[4]), this->positionOf(part[1], part[3], part[5])};
  }

  /// Halves a part along its longest side.
  std::pair<Extent, Extent> halves(const Extent& part) const
  {
    std::size_t longest = 0;
    double length = -1;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const int steps = part[2 * axis + 1] - part[2 * axis];
      if (steps > 0 && steps * grid_.spacing[static_cast<int>(axis)] > length)
      {
        longest = axis;
        length = steps * grid_.spacing[static_cast<int>(axis)];
      }
    }
    const int first = part[2 * longest], last = part[2 * longest + 1];
    std::pair<Extent, Extent> halves = {part, part};
    halves.first[2 * longest + 1] = first + (last - first) / 2;
    halves.second[2 * longest] = first + (last - first) / 2 + 1;
    return halves;
  }

  template <class Function> void forEach(const Extent& part, const Function& f) const
  {
    const Extent asked = common(part, asked_);
    for (int k = asked[4]; k <= asked[5]; ++k)
    {
      for (int j = asked[2]; j <= asked[3]; ++j)
      {
        for (int i = asked[0]; i <= asked[1]; ++i)
        {
          f(this->positionOf(i, j, k), sampleNumber(asked_, {i, j, k}));
        }
      }
    }
  }

  double scale() const { return scale_; }

private:
  Eigen::Vector3d positionOf(int i, int j, int k) const
  {
    return scaledSample(grid_, i, j, k, scale_);
  }

  const Grid& grid_;
  const Extent asked_;
  const double scale_;
};

} // namespace winding
