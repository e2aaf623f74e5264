#include "rays/TriangleColumns.h"

#include <algorithm>
#include <atomic>
#include <vector>

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

TriangleIds TriangleColumns::near(const Ray* first, const Ray* last) const
{
  std::vector<std::size_t> columns;
  std::transform(first, last, std::back_inserter(columns),
    [this](const Ray& ray) { return columns_.of(ray.start()); });
  std::sort(columns.begin(), columns.end());
  columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
  TriangleIds ids;
  for (const std::size_t column : columns)
  {
    ids.insert(ids.end(), triangles_.begin(column), triangles_.end(column));
  }
  if (columns.size() > 1)
  {
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  }
  return ids;
}

} // namespace winding
