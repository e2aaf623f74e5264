// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/ClearCells.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

namespace winding
{

namespace
{

/// The number of cells along each axis: cells are about cubes, `wanted` of them or fewer, and far
/// larger than the margin.
Eigen::Array3i dimensionsFor(
  const Eigen::Array3d& sizes, const Eigen::Array3d& margin, std::size_t wanted)
{
  // An axis along which the box is flatter than a thousandth of its longest side has one cell.
  const Eigen::Array3d relative = sizes / sizes.maxCoeff();
  double product = 1;
  int axes = 0;
  for (const double size : relative)
  {
    product *= size >= 1e-3 ? size : 1;
    axes += size >= 1e-3;
  }
  const double perLength = std::pow(static_cast<double>(wanted) / product, 1.0 / axes);
  constexpr double most = 1000, marginsPerCell = 64;
  return (relative >= 1e-3)
    .select(relative * perLength, 1.0)
    .min(sizes / (marginsPerCell * margin.max(std::numeric_limits<double>::min())))
    .min(most)
    .max(1.0)
    .cast<int>();
}

} // namespace

/// Marks the cells that triangles reach, on several threads at once.
class ClearCells::Marks
{
public:
  explicit Marks(const ClearCells& cells)
    : cells_(cells)
    , marks_(std::make_unique<std::atomic<bool>[]>(cells.runs_.size()))
  {
  }

  bool isReached(std::size_t cell) const { return marks_[cell].load(std::memory_order_relaxed); }

  void mark(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
  {
    const Eigen::Array3i first = cells_.cellOf(a.cwiseMin(b).cwiseMin(c) - cells_.margin_);
    const Eigen::Array3i last = cells_.cellOf(a.cwiseMax(b).cwiseMax(c) + cells_.margin_);
    if ((last - first).maxCoeff() > mostSteps)
    {
      this->markHalves(a, b, c);
      return;
    }
    for (int z = first[2]; z <= last[2]; ++z)
    {
      for (int y = first[1]; y <= last[1]; ++y)
      {
        const std::size_t row = cells_.numberOf({0, y, z});
        for (int x = first[0]; x <= last[0]; ++x)
        {
          std::atomic<bool>& isMarked = marks_[row + static_cast<std::size_t>(x)];
          if (!isMarked.load(std::memory_order_relaxed))
          {
            isMarked.store(true, std::memory_order_relaxed);
          }
        }
      }
    }
  }

private:
  /// A part of a triangle is small enough where its box has no more cells than two along each axis.
  static constexpr int mostSteps = 1;

  /// Cuts the side across most cells in two. It is a cell long or nearly so, which is far more than
  /// the margin: so its halves are shorter, whatever rounding does.
  void markHalves(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
  {
    const auto cellsAlong = [this](const Eigen::Vector3d& from, const Eigen::Vector3d& to)
    {
      return ((to - from).array().abs() * cells_.cellsPerLength_).maxCoeff();
    };
    const double ab = cellsAlong(a, b), bc = cellsAlong(b, c), ca = cellsAlong(c, a);
    if (ab >= bc && ab >= ca)
    {
      const Eigen::Vector3d middle = 0.5 * a + 0.5 * b;
      this->mark(a, middle, c);
      this->mark(middle, b, c);
    }
    else if (bc >= ca)
    {
      this->markHalves(b, c, a);
    }
    else
    {
      this->markHalves(c, a, b);
    }
  }

  const ClearCells& cells_;
  std::unique_ptr<std::atomic<bool>[]> marks_;
};

ClearCells::ClearCells(
  const CrossedChain& chain, const Bounds& bounds, std::size_t wantedCells, Executor& executor)
  : bounds_(bounds)
  , margin_(16 * std::numeric_limits<double>::epsilon() *
            bounds.min().cwiseAbs().cwiseMax(bounds.max().cwiseAbs()))
  , dimensions_(dimensionsFor(bounds.sizes(), margin_, wantedCells))
  , cellsPerLength_(
      (dimensions_ > 1).select(dimensions_.cast<double>() / bounds.sizes().array(), 0.0))
  , runs_(static_cast<std::size_t>(dimensions_.prod()))
{
  constexpr std::size_t trianglesPerBlock = 1024;
  Marks marks(*this);
  runBlocks(
    chain.size(), trianglesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const Triangle& ids = chain[i];
        marks.mark(chain.vertex(ids[0]), chain.vertex(ids[1]), chain.vertex(ids[2]));
      }
    },
    executor);
  this->findRuns(marks);
}

void ClearCells::findRuns(const Marks& marks)
{
  const Eigen::Array3d size = bounds_.sizes().array() / dimensions_.cast<double>();
  for (std::size_t cell = 0; cell < runs_.size(); ++cell)
  {
    if (marks.isReached(cell))
    {
      runs_[cell] = reached;
      continue;
    }
    const std::size_t width = static_cast<std::size_t>(dimensions_[0]);
    const std::size_t x = cell % width, row = cell / width;
    const bool goesOn = x > 0 && runs_[cell - 1] != reached;
    if (!goesOn)
    {
      const std::size_t height = static_cast<std::size_t>(dimensions_[1]);
      const Eigen::Array3d index(static_cast<double>(x), static_cast<double>(row % height),
        static_cast<double>(row / height));
      places_.push_back(bounds_.min().array() + (index + 0.5) * size);
    }
    runs_[cell] = static_cast<std::int32_t>(places_.size()) - 1;
  }
}

} // namespace winding
