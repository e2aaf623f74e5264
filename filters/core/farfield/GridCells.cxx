// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/GridCells.h"

#include "source/UnitScale.h"

#include <algorithm>
#include <cmath>

namespace winding
{

bool isInReachOfSingles(const Grid& grid, const Bounds& sources, double scale)
{
  if (sources.isEmpty())
  {
    return true;
  }
  const Eigen::Vector3d last = grid.sample(grid.dimensions - Eigen::Vector3i::Ones());
  const auto isNear = [&](const Eigen::Vector3d& sample)
  {
    return (sample - sources.min()).cwiseAbs().maxCoeff() * scale <= farthestOffset;
  };
  return isNear(grid.firstSample) && isNear(last);
}

GridCells::GridCells(const Grid& grid, const Extent& extent, double scale, int order)
  : grid_(grid)
  , extent_(extent)
  , scale_(scale)
  , spacing_(grid.spacing * scale)
{
  // Blocks are to be as cubic as can be, so exponents are larger along axes where samples are
  // closer. Axes with one sample do not count for what is close.
  double fineness = 0;
  int axes = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    fineness -= grid.dimensions[axis] > 1 ? std::log2(spacing_[axis]) : 0;
    axes += grid.dimensions[axis] > 1;
  }
  const double usual = axes == 3 ? 3 : 4;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double exponent = usual - std::log2(spacing_[axis]) - fineness / std::max(axes, 1);
    exponents_[axis] =
      grid.dimensions[axis] > 1 ? static_cast<int>(std::clamp(std::round(exponent), 0.0, 9.0)) : 0;
  }
  int top = 0;
  const auto holdsAll = [&]
  {
    return this->sizeOf(top, 0) >= grid.dimensions[0] &&
           this->sizeOf(top, 1) >= grid.dimensions[1] && this->sizeOf(top, 2) >= grid.dimensions[2];
  };
  while (!holdsAll())
  {
    ++top;
  }
  levels_.resize(static_cast<std::size_t>(top + 1));
  for (int number = top; number >= 0; --number)
  {
    TargetLevel& level = levels_[static_cast<std::size_t>(number)];
    Eigen::Vector3d size, quarter;
    for (int axis = 0; axis < 3; ++axis)
    {
      size[axis] = static_cast<double>(this->sizeOf(number, axis));
      const bool isTop = number == top;
      const bool isCut = !isTop && this->sizeOf(number, axis) < this->sizeOf(number + 1, axis);
      quarter[axis] = isCut ? 0.5 * size[axis] * spacing_[axis] : 0;
    }
    level.side = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double length = grid.dimensions[axis] > 1 ? size[axis] * spacing_[axis] : 0;
      level.side = std::max(level.side, length);
    }
    level.radius = 0.5 * (size - Eigen::Vector3d::Ones()).cwiseProduct(spacing_).norm();
    // Any side will do for a single sample, but powers of a huge one would leave the range.
    level.side = level.radius > 0 ? level.side : 1e-3;
    if (number < top)
    {
      this->setShifts(order, number, quarter);
    }
  }
  // Tasks are cells as large as can be, but with enough bars of cells along x to keep some threads
  // busy.
  const int blockLevel = exponents_.maxCoeff();
  const auto bars = [&](int level)
  {
    const auto along = [&](int axis)
    {
      return (grid.dimensions[axis] + this->sizeOf(level, axis) - 1) / this->sizeOf(level, axis);
    };
    return static_cast<double>(along(1)) * along(2);
  };
  constexpr int enough = 64;
  taskLevel_ = top;
  while (taskLevel_ > std::min(blockLevel, top) && bars(taskLevel_) < enough)
  {
    --taskLevel_;
  }
}

std::int64_t GridCells::sizeOf(int level, int axis) const
{
  // An axis of one sample has nothing to divide.
  return grid_.dimensions[axis] == 1
           ? 1
           : std::int64_t(1) << std::max(0, exponents_[axis] + level - exponents_.maxCoeff());
}

TargetCell GridCells::cellAt(int level, const Eigen::Vector3i& index) const
{
  TargetCell cell;
  cell.level = level;
  cell.index = index;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto size = static_cast<double>(this->sizeOf(level, axis));
    const double middle = static_cast<double>(index[axis]) * size + 0.5 * (size - 1);
    cell.center[axis] =
      scaledCoordinate(grid_.firstSample[axis] + middle * grid_.spacing[axis], scale_);
  }
  cell.samples = sampleCount(this->samplesOf(cell, extent_));
  cell.allSamples = sampleCount(this->samplesOf(cell, grid_.wholeExtent()));
  return cell;
}

Extent GridCells::samplesOf(const TargetCell& cell) const
{
  return this->samplesOf(cell, extent_);
}

Extent GridCells::samplesOf(const TargetCell& cell, const Extent& extent) const
{
  Extent part;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::int64_t size = this->sizeOf(cell.level, axis);
    const std::int64_t first = cell.index[axis] * size;
    part[2 * axis] = static_cast<int>(std::max<std::int64_t>(first, extent[2 * axis]));
    part[2 * axis + 1] =
      static_cast<int>(std::min<std::int64_t>(first + size - 1, extent[2 * axis + 1]));
  }
  return part;
}

TargetCell GridCells::root() const
{
  return this->cellAt(static_cast<int>(levels_.size()) - 1, Eigen::Vector3i::Zero());
}

int GridCells::childrenOf(const TargetCell& cell, Child (&children)[8]) const
{
  if (cell.level == 0)
  {
    return 0;
  }
  int count = 0;
  for (int octant = 0; octant < 8; ++octant)
  {
    Eigen::Vector3i index = cell.index;
    bool exists = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int half = octant >> axis & 1;
      if (this->sizeOf(cell.level - 1, axis) < this->sizeOf(cell.level, axis))
      {
        index[axis] = 2 * index[axis] + half;
      }
      else
      {
        exists = exists && half == 0;
      }
    }
    if (exists)
    {
      children[count] = {this->cellAt(cell.level - 1, index), octant};
      count += children[count].cell.samples > 0;
    }
  }
  return count;
}

float GridCells::offsetIn(const TargetCell& cell, int axis, int sample) const
{
  const auto size = static_cast<double>(this->sizeOf(cell.level, axis));
  const double middle = static_cast<double>(cell.index[axis]) * size + 0.5 * (size - 1);
  return static_cast<float>((sample - middle) * (spacing_[axis] / this->level(cell.level).side));
}

void GridCells::fill(const TargetCell& cell, std::size_t first, TargetBlock& block) const
{
  const Extent part = this->samplesOf(cell);
  block.samples.count = std::min(SampleBlock::capacity, cell.samples - first);
  Eigen::Vector3i at = sampleIndex(part, first);
  const auto width = static_cast<std::size_t>(part[1] - part[0] + 1);
  for (std::size_t n = 0; n < block.samples.count;)
  {
    const std::size_t inRow =
      std::min(block.samples.count - n, static_cast<std::size_t>(part[1] - at[0] + 1));
    const Eigen::Vector3d position = grid_.sample(at[0], at[1], at[2]);
    std::fill_n(block.samples.y + n, inRow, scaledCoordinate(position[1], scale_));
    std::fill_n(block.samples.z + n, inRow, scaledCoordinate(position[2], scale_));
    std::fill_n(block.v + n, inRow, this->offsetIn(cell, 1, at[1]));
    std::fill_n(block.w + n, inRow, this->offsetIn(cell, 2, at[2]));
    if (n >= width && inRow == width)
    {
      // All rows of a cell have the same x coordinates.
      std::copy_n(block.samples.x + n - width, width, block.samples.x + n);
      std::copy_n(block.u + n - width, width, block.u + n);
    }
    else
    {
      for (std::size_t m = 0; m < inRow; ++m)
      {
        const int i = at[0] + static_cast<int>(m);
        block.samples.x[n + m] = scaledCoordinate(grid_.sample(i, at[1], at[2])[0], scale_);
      }
      this->fillOffsets(cell, at[0], inRow, block.u + n);
    }
    n += inRow;
    at[0] = part[0];
    at[2] += at[1] == part[3];
    at[1] = at[1] == part[3] ? part[2] : at[1] + 1;
  }
}

/// Writes offsetIn() of consecutive samples along x.
void GridCells::fillOffsets(
  const TargetCell& cell, int first, std::size_t count, float* offsets) const
{
  const auto size = static_cast<double>(this->sizeOf(cell.level, 0));
  const double middle = static_cast<double>(cell.index[0]) * size + 0.5 * (size - 1);
  const double factor = spacing_[0] / this->level(cell.level).side;
  for (std::size_t n = 0; n < count; ++n)
  {
    offsets[n] = static_cast<float>((first + static_cast<double>(n) - middle) * factor);
  }
}

void GridCells::store(const TargetCell& cell, std::size_t first, std::size_t count,
  const float* values, const bool* isSuspect) const
{
  const Extent part = this->samplesOf(cell);
  for (std::size_t done = 0; done < count;)
  {
    const Eigen::Vector3i at = sampleIndex(part, first + done);
    const std::size_t inRow = std::min(count - done, static_cast<std::size_t>(part[1] - at[0] + 1));
    sink_->row(at[0], at[1], at[2], inRow, values + done, isSuspect ? isSuspect + done : nullptr);
    done += inRow;
  }
}

std::size_t GridCells::rowsOf(const TargetCell& cell) const
{
  constexpr std::size_t small = 512;
  if (cell.allSamples <= small)
  {
    return 0;
  }
  const Extent part = this->samplesOf(cell);
  return cell.samples / static_cast<std::size_t>(part[1] - part[0] + 1);
}

void GridCells::storePolynomial(const TargetCell& cell, int order, const float* coefficients) const
{
  if (this->rowsOf(cell) == 0)
  {
    TargetCells::storePolynomial(cell, order, coefficients);
    return;
  }
  // The polynomial loses one variable in every plane and another in every row, so that one
  // multiplication and addition per degree is left for each sample of a row.
  const Extent part = this->samplesOf(cell);
  alignas(64) float u[SampleBlock::capacity], values[SampleBlock::capacity];
  for (int begin = part[0]; begin <= part[1]; begin += static_cast<int>(SampleBlock::capacity))
  {
    const std::size_t count =
      std::min(SampleBlock::capacity, static_cast<std::size_t>(part[1] - begin + 1));
    this->fillOffsets(cell, begin, count, u);
    for (int k = part[4]; k <= part[5]; ++k)
    {
      const float w = this->offsetIn(cell, 2, k);
      float plane[(largestOrder + 1) * (largestOrder + 2) / 2];
      const float* from = coefficients;
      float* to = plane;
      for (int i = order; i >= 0; --i)
      {
        for (int j = order - i; j >= 0; --j)
        {
          float sum = 0;
          for (int degree = order - i - j; degree >= 0; --degree)
          {
            sum = sum * w + *from++;
          }
          *to++ = sum;
        }
      }
      for (int j = part[2]; j <= part[3]; ++j)
      {
        const float v = this->offsetIn(cell, 1, j);
        float row[largestOrder + 1];
        from = plane;
        for (int i = 0; i <= order; ++i)
        {
          float sum = 0;
          for (int degree = i; degree >= 0; --degree)
          {
            sum = sum * v + *from++;
          }
          row[i] = sum;
        }
        evaluateRow(order, row, u, count, values);
        sink_->row(begin, j, k, count, values, nullptr);
      }
    }
  }
}

} // namespace winding
