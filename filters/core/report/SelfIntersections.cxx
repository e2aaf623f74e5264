// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/SelfIntersections.h"

#include "base/Bounds.h"
#include "rays/Predicates.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>

namespace winding
{

namespace
{

/// A cell of a coarse grid, and a triangle whose box meets it.
struct Entry
{
  std::array<std::int32_t, 3> cell;
  std::uint32_t triangle;

  bool operator<(const Entry& other) const
  {
    return cell != other.cell ? cell < other.cell : triangle < other.triangle;
  }
};

/// Finds the pairs of triangles that pass through each other.
class TrianglePairs
{
public:
  TrianglePairs(const std::vector<Eigen::Vector3d>& vertices, const TriangleList& triangles)
    : vertices_(vertices)
    , triangles_(triangles)
    , boxes_(triangles.size())
  {
  }

  std::size_t count(Executor& executor);

private:
  const Eigen::Vector3d& vertex(std::int32_t id) const
  {
    return vertices_[static_cast<std::size_t>(id)];
  }
  std::array<std::int32_t, 3> cellOf(const Eigen::Vector3d& point) const;
  std::vector<Entry> entries() const;
  bool passes(std::int32_t from, std::int32_t to, const Triangle& through) const;
  bool doIntersect(const Triangle& a, const Triangle& b) const;
  std::size_t countIn(const Entry* first, const Entry* last) const;

  const std::vector<Eigen::Vector3d>& vertices_;
  const TriangleList& triangles_;
  std::vector<Bounds> boxes_;
  Eigen::Vector3d origin_;
  double cellSize_ = 1;
};

std::array<std::int32_t, 3> TrianglePairs::cellOf(const Eigen::Vector3d& point) const
{
  const Eigen::Vector3d place = (point - origin_) / cellSize_;
  return {static_cast<std::int32_t>(place[0]), static_cast<std::int32_t>(place[1]),
    static_cast<std::int32_t>(place[2])};
}

/// Every triangle in each cell that its box meets, sorted.
std::vector<Entry> TrianglePairs::entries() const
{
  std::vector<Entry> entries;
  entries.reserve(4 * triangles_.size());
  for (std::size_t n = 0; n < triangles_.size(); ++n)
  {
    const auto low = this->cellOf(boxes_[n].min()), high = this->cellOf(boxes_[n].max());
    for (std::int32_t k = low[2]; k <= high[2]; ++k)
    {
      for (std::int32_t j = low[1]; j <= high[1]; ++j)
      {
        for (std::int32_t i = low[0]; i <= high[0]; ++i)
        {
          entries.push_back({{i, j, k}, static_cast<std::uint32_t>(n)});
        }
      }
    }
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

/// Whether the segment between two vertices passes through a triangle.
bool TrianglePairs::passes(std::int32_t from, std::int32_t to, const Triangle& through) const
{
  const Eigen::Vector3d &p = this->vertex(from), &q = this->vertex(to);
  const Eigen::Vector3d &a = this->vertex(through[0]), &b = this->vertex(through[1]);
  const Eigen::Vector3d& c = this->vertex(through[2]);
  if (sideOfPlane(a, b, c, p) == sideOfPlane(a, b, c, q))
  {
    return false;
  }
  const int side = sideOfPlane(p, q, a, b);
  return side == sideOfPlane(p, q, b, c) && side == sideOfPlane(p, q, c, a);
}

bool TrianglePairs::doIntersect(const Triangle& a, const Triangle& b) const
{
  std::array<std::size_t, 3> sharedOfA, sharedOfB;
  std::size_t shared = 0;
  for (std::size_t m = 0; m < 3; ++m)
  {
    for (std::size_t n = 0; n < 3; ++n)
    {
      if (a[m] == b[n])
      {
        sharedOfA[shared] = m;
        sharedOfB[shared++] = n;
      }
    }
  }
  if (shared == 1)
  {
    const std::size_t m = sharedOfA[0], n = sharedOfB[0];
    return this->passes(a[(m + 1) % 3], a[(m + 2) % 3], b) ||
           this->passes(b[(n + 1) % 3], b[(n + 2) % 3], a);
  }
  bool found = false;
  for (std::size_t n = 0; n < 3 && shared == 0 && !found; ++n)
  {
    found = this->passes(a[n], a[(n + 1) % 3], b) || this->passes(b[n], b[(n + 1) % 3], a);
  }
  return found;
}

/// Counts the pairs of a cell's triangles; a pair counts in the cell of the low corner of what
/// their boxes have in common.
std::size_t TrianglePairs::countIn(const Entry* first, const Entry* last) const
{
  std::size_t count = 0;
  for (const Entry* a = first; a != last; ++a)
  {
    for (const Entry* b = a + 1; b != last; ++b)
    {
      const Bounds &boxA = boxes_[a->triangle], &boxB = boxes_[b->triangle];
      if (boxA.intersects(boxB) && this->cellOf(boxA.min().cwiseMax(boxB.min())) == first->cell)
      {
        count += this->doIntersect(triangles_[a->triangle], triangles_[b->triangle]);
      }
    }
  }
  return count;
}

std::size_t TrianglePairs::count(Executor& executor)
{
  Bounds all;
  Eigen::Vector3d sizes = Eigen::Vector3d::Zero();
  for (std::size_t n = 0; n < triangles_.size(); ++n)
  {
    for (const std::int32_t id : triangles_[n])
    {
      boxes_[n].extend(this->vertex(id));
    }
    all.extend(boxes_[n]);
    sizes += boxes_[n].sizes();
  }
  if (triangles_.empty())
  {
    return 0;
  }
  // Few triangles meet many cells, and few cells have many triangles. Cells have numbers in the
  // range of their type.
  constexpr double mostCells = 1 << 20;
  cellSize_ = std::max(1.5 * sizes.maxCoeff() / static_cast<double>(triangles_.size()),
    all.sizes().maxCoeff() / mostCells);
  cellSize_ = cellSize_ > 0 ? cellSize_ : 1;
  origin_ = all.min();
  const std::vector<Entry> entries = this->entries();
  constexpr std::size_t perBlock = 4096;
  std::vector<std::size_t> counts((entries.size() + perBlock - 1) / perBlock);
  runBlocks(
    entries.size(), perBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      const auto isOther = [&](std::size_t n)
      {
        return entries[n].cell != entries[n - 1].cell;
      };
      // A block has the cells that begin in it.
      for (std::size_t begin = first; begin < last; ++begin)
      {
        if (begin > 0 && !isOther(begin))
        {
          continue;
        }
        std::size_t end = begin + 1;
        while (end < entries.size() && !isOther(end))
        {
          ++end;
        }
        counts[block] += this->countIn(entries.data() + begin, entries.data() + end);
        begin = end - 1;
      }
    },
    executor);
  return std::accumulate(counts.begin(), counts.end(), std::size_t(0));
}

} // namespace

std::size_t countSelfIntersections(
  const std::vector<Eigen::Vector3d>& vertices, const TriangleList& triangles, Executor& executor)
{
  return TrianglePairs(vertices, triangles).count(executor);
}

} // namespace winding
