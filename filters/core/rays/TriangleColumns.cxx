// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/TriangleColumns.h"

#include <atomic>

namespace winding
{

namespace
{

/// The number of triangles in a block: small inputs shall occupy several cores.
constexpr std::size_t perBlock = 4096;

/// The most columns that triangles reach on average.
constexpr std::size_t mostEntries = 16;

RayBox boxOf(const Bounds& bounds, double scale)
{
  RayBox box;
  box.add(bounds.min() * scale);
  box.add(bounds.max() * scale);
  return box;
}

} // namespace

TriangleColumns::TriangleColumns(const RayCounter& counter, std::size_t triangles,
  const Bounds& bounds, double scale, Executor& executor)
  : columns_(boxOf(bounds, scale), mostBuckets)
{
  std::atomic<std::size_t> entries{0};
  runBlocks(
    triangles, perBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      std::size_t ours = 0;
      for (std::size_t i = first; i < last; ++i)
      {
        ours += columns_.of(counter.box(static_cast<std::uint32_t>(i))).size();
      }
      entries += ours;
    },
    executor);
  if (entries > mostEntries * triangles)
  {
    return;
  }
  triangles_ = distribute<std::uint32_t>(
    triangles, columns_.count(),
    [&](std::size_t first, std::size_t last, const auto& put)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const auto id = static_cast<std::uint32_t>(i);
        const ColumnRange range = columns_.of(counter.box(id));
        for (int z = range.firstZ; z <= range.lastZ; ++z)
        {
          for (int y = range.firstY; y <= range.lastY; ++y)
          {
            put(columns_.number(y, z), id);
          }
        }
      }
    },
    executor, perBlock);
}

} // namespace winding
