// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "source/Weld.h"

#include "base/Bounds.h"
#include "base/BucketSort.h"
#include "base/Refusal.h"

#include <cstring>
#include <limits>
#include <numeric>

namespace winding
{

namespace
{

constexpr std::size_t pointsPerBlock = 16384;

/// Adding +0 turns −0 into +0, which compares equal but has other bits to hash.
Eigen::Vector3d withoutNegativeZero(const Eigen::Vector3d& point)
{
  return point.array() + 0.0;
}

std::uint64_t hashOf(const Eigen::Vector3d& point)
{
  std::uint64_t hash = 0;
  for (const double coordinate : point)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &coordinate, sizeof bits);
    // Multiplying and folding spreads even coordinates that share most bits over the table.
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 32;
  }
  return hash;
}

} // namespace

/// A hash table with open addressing and linear probing that finds equal points among the points
/// that are added to it, in their order.
class Weld::Table
{
public:
  Table(Weld& weld, std::size_t points)
    : weld_(weld)
  {
    std::size_t size = 16;
    while (size < 2 * points)
    {
      size *= 2;
    }
    slots_.assign(size, {0, 0});
  }

  /// position() is asked for only where hashes are equal: it may lie far away in memory.
  template <class Position> void add(const Item& item, const Position& position)
  {
    std::size_t i = item.hash & (slots_.size() - 1);
    while (slots_[i].point != 0)
    {
      const std::uint32_t other = slots_[i].point - 1;
      if (slots_[i].hash == item.hash && weld_.position(other) == position())
      {
        weld_.targets_[item.point] = other;
        weld_.states_[item.point].store(repeated, std::memory_order_relaxed);
        return;
      }
      i = (i + 1) & (slots_.size() - 1);
    }
    slots_[i] = {item.point + 1, item.hash};
  }

private:
  Weld& weld_;
  std::vector<Item> slots_; ///< their `point` is the point's number + 1, or 0 where there is none
};

Weld::Weld(const std::vector<TrianglesView>& views)
  : views_(views)
  , points_(views, [](const TrianglesView& view) { return view.points.size(); })
{
  if (points_.size() > std::numeric_limits<std::uint32_t>::max())
  {
    throw Refusal("split the surface: it has more than 4294967295 points");
  }
  states_ = std::make_unique<std::atomic<unsigned char>[]>(points_.size()); // all of them unused
}

Eigen::Vector3d Weld::position(std::size_t point) const
{
  const std::size_t view = points_.viewOf(point);
  return views_[view].points[point - points_.start(view)];
}

/// Calls work(point, position) for each used point among first … last − 1.
template <class Work>
void Weld::forEachUsed(std::size_t first, std::size_t last, const Work& work) const
{
  points_.forEachPart(first, last,
    [&](std::size_t view, std::size_t begin, std::size_t end, std::size_t point)
    {
      for (std::size_t i = begin; i < end; ++i, ++point)
      {
        if (states_[point].load(std::memory_order_relaxed) == used)
        {
          work(point, withoutNegativeZero(views_[view].points[i]));
        }
      }
    });
}

void Weld::makeVertices(Surface& surface, Executor& executor)
{
  targets_.reset(new std::uint32_t[points_.size()]); // used points' are written below
  if (points_.size() > surface.inputTriangles)
  {
    this->weldBlocks(executor);
  }
  this->weldBuckets(executor);

  std::vector<std::size_t> starts((points_.size() + pointsPerBlock - 1) / pointsPerBlock + 1, 0);
  runBlocks(
    points_.size(), pointsPerBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      std::size_t count = 0;
      for (std::size_t point = first; point < last; ++point)
      {
        count += states_[point].load(std::memory_order_relaxed) == used;
      }
      starts[block + 1] = count;
    },
    executor);
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  if (starts.back() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
  {
    throw Refusal("split the surface: it has more than 2147483647 vertices");
  }

  surface.vertices.resize(starts.back());
  std::vector<Bounds> bounds(starts.size() - 1);
  runBlocks(
    points_.size(), pointsPerBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      std::size_t vertex = starts[block];
      Bounds ofBlock;
      this->forEachUsed(first, last,
        [&](std::size_t point, const Eigen::Vector3d& position)
        {
          surface.vertices[vertex] = position;
          ofBlock.extend(position);
          targets_[point] = static_cast<std::uint32_t>(vertex++);
        });
      bounds[block] = ofBlock;
    },
    executor);
  for (const Bounds& ofBlock : bounds)
  {
    surface.bounds.extend(ofBlock);
  }
}

void Weld::weldBlocks(Executor& executor)
{
  // Blocks are large, to find most of the equal points, but their tables stay in a core's second
  // cache.
  runBlocks(
    points_.size(), 8 * pointsPerBlock,
    [this](std::size_t, std::size_t first, std::size_t last)
    {
      Table table(*this, last - first);
      this->forEachUsed(first, last,
        [&table](std::size_t point, const Eigen::Vector3d& position)
        {
          table.add(
            {static_cast<std::uint32_t>(point), static_cast<std::uint32_t>(hashOf(position))},
            [&position] { return position; });
        });
    },
    executor);
}

void Weld::weldBuckets(Executor& executor)
{
  // The items of a bucket and their table stay in a core's first cache.
  constexpr std::size_t wantedPoints = 2048;
  const std::size_t buckets = bucketsFor(points_.size(), bucketShift(points_.size(), wantedPoints));
  const Buckets<Item> items = distribute<Item>(
    points_.size(), buckets,
    [&](std::size_t first, std::size_t last, const auto& put)
    {
      this->forEachUsed(first, last,
        [&](std::size_t point, const Eigen::Vector3d& position)
        {
          const std::uint64_t hash = hashOf(position);
          put((hash >> 32) * buckets >> 32,
            Item{static_cast<std::uint32_t>(point), static_cast<std::uint32_t>(hash)});
        });
    },
    executor);
  runBlocks(
    buckets, 1,
    [&](std::size_t bucket, std::size_t, std::size_t)
    {
      Table table(*this, items.size(bucket));
      for (const Item* item = items.begin(bucket); item != items.end(bucket); ++item)
      {
        table.add(*item, [this, item] { return this->position(item->point); });
      }
    },
    executor);
}

} // namespace winding
