// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/ReachOfTriangles.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <mutex>

namespace winding
{

namespace
{

/// The number of triangles in a block: small inputs shall occupy several cores.
constexpr std::size_t perBlock = 4096;

/// The most entries per triangle that the lists for the columns of one round have.
constexpr std::size_t mostEntries = 16;

} // namespace

/// The columns first … last − 1, and the rows that they are in.
struct ReachOfTriangles::Window
{
  Window(std::size_t columnsBegin, std::size_t columnsEnd, const Columns& columns)
    : first(columnsBegin)
    , last(columnsEnd)
    , firstRow(static_cast<std::uint16_t>(columnsBegin / columns.perRow()))
    , lastRow(static_cast<std::uint16_t>((columnsEnd - 1) / columns.perRow()))
  {
  }

  std::size_t first, last;
  std::uint16_t firstRow, lastRow;
};

ReachOfTriangles::ReachOfTriangles(const RayCounter& counter, const CandidateTriangles& triangles,
  const RaysInColumns& rays, Executor& executor)
  : counter_(counter)
  , triangles_(triangles)
  , columns_(rays.columns)
  , executor_(executor)
  , ranges_(triangles.size())
{
  constexpr std::size_t columnsPerBlock = 64;
  std::vector<RayBox> boxes(columns_.count());
  runBlocks(
    boxes.size(), columnsPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t column = first; column < last; ++column)
      {
        boxes[column] = RayBox(rays.starts[column], rays.starts[column + 1]);
      }
    },
    executor);
  RayBox all;
  for (const RayBox& box : boxes)
  {
    all.add(box);
  }
  std::atomic<std::size_t> inBoxes{0};
  runBlocks(
    triangles.size(), perBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      std::size_t ours = 0;
      for (std::size_t i = first; i < last; ++i)
      {
        ranges_[i] = this->rangeOf(triangles[i], all, boxes);
        ours += ranges_[i].isEmpty() ? 0 : ranges_[i].size();
      }
      inBoxes += ours;
    },
    executor);
  this->makeRounds(inBoxes);
}

/// Calls visit(column) for the columns of a window that triangle i reaches.
template <class Visit>
void ReachOfTriangles::forEachColumn(std::size_t i, const Window& window, const Visit& visit) const
{
  ColumnRange range = ranges_[i];
  range.firstZ = std::max(range.firstZ, window.firstRow);
  range.lastZ = std::min(range.lastZ, window.lastRow);
  if (range.isEmpty())
  {
    return;
  }
  const auto visitOurs = [&](std::size_t column)
  {
    if (column >= window.first && column < window.last)
    {
      visit(column);
    }
  };
  if (!range.isNarrow())
  {
    counter_.footprint(triangles_[i], columns_, range).forEach(visitOurs);
    return;
  }
  for (int z = range.firstZ; z <= range.lastZ; ++z)
  {
    for (int y = range.firstY; y <= range.lastY; ++y)
    {
      visitOurs(columns_.number(y, z));
    }
  }
}

Buckets<std::uint32_t> ReachOfTriangles::inColumns(std::size_t first, std::size_t last) const
{
  const Window window(first, last, columns_);
  return distribute<std::uint32_t>(
    triangles_.size(), last - first,
    [&](std::size_t from, std::size_t to, const auto& put)
    {
      for (std::size_t i = from; i < to; ++i)
      {
        this->forEachColumn(
          i, window, [&](std::size_t column) { put(column - first, triangles_[i]); });
      }
    },
    executor_, perBlock);
}

ColumnRange ReachOfTriangles::rangeOf(
  std::uint32_t id, const RayBox& all, const std::vector<RayBox>& boxes) const
{
  const TriangleBox box = counter_.box(id);
  if (!all.isReachedBy(box))
  {
    return ColumnRange::none();
  }
  const ColumnRange range = columns_.of(box);
  const bool isReached =
    range.size() > 1 || boxes[columns_.number(range.firstY, range.firstZ)].isReachedBy(box);
  return isReached ? range : ColumnRange::none();
}

void ReachOfTriangles::makeRounds(std::size_t inBoxes)
{
  const std::size_t most = mostEntries * triangles_.size();
  rounds_ = {0};
  if (inBoxes > most)
  {
    std::vector<std::size_t> entries(columns_.count(), 0);
    std::mutex mutex;
    runBlocks(
      triangles_.size(), perBlock,
      [&](std::size_t, std::size_t first, std::size_t last)
      {
        std::vector<std::size_t> ours(entries.size(), 0);
        const Window window(0, entries.size(), columns_);
        for (std::size_t i = first; i < last; ++i)
        {
          this->forEachColumn(i, window, [&ours](std::size_t column) { ++ours[column]; });
        }
        const std::lock_guard<std::mutex> lock(mutex);
        std::transform(ours.begin(), ours.end(), entries.begin(), entries.begin(), std::plus<>());
      },
      executor_);
    std::size_t sum = 0;
    for (std::size_t column = 0; column < entries.size(); ++column)
    {
      if (sum + entries[column] > most)
      {
        rounds_.push_back(column);
        sum = 0;
      }
      sum += entries[column];
    }
  }
  rounds_.push_back(columns_.count());
}

} // namespace winding
