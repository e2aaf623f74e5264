#include "Weld.h"

#include "BucketSort.h"
#include "Refusal.h"

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
    // Multiply and fold: coordinates that share most bits must still spread over the table.
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 32;
  }
  return hash;
}

} // namespace

Weld::Weld(const std::vector<TrianglesView>& views)
  : views_(views)
  , points_(views, [](const TrianglesView& view) { return view.points.size(); })
{
  if (points_.size() > std::numeric_limits<std::uint32_t>::max())
  {
    throw Refusal("the surface has more than 4294967295 points; split it");
  }
  states_.reset(new std::atomic<unsigned char>[points_.size()]()); // all of them unused
}

Eigen::Vector3d Weld::position(std::size_t point) const
{
  const std::size_t view = points_.viewOf(point);
  return views_[view].points[point - points_.start(view)];
}

/// Calls work(point, position) for the used ones of the points first … last − 1.
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
  targets_.reset(new std::uint32_t[points_.size()]); // those of used points are written below
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
    throw Refusal("the surface has more than 2147483647 vertices; split it");
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
  runBlocks(
    points_.size(), pointsPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      std::vector<Item> items;
      items.reserve(last - first);
      this->forEachUsed(first, last,
        [&items](std::size_t point, const Eigen::Vector3d& position)
        {
          items.push_back(
            {static_cast<std::uint32_t>(point), static_cast<std::uint32_t>(hashOf(position))});
        });
      this->weldItems(items.data(), items.data() + items.size());
    },
    executor);
}

void Weld::weldBuckets(Executor& executor)
{
  // The items of a bucket and their table stay in a core's first cache.
  constexpr std::size_t wantedPoints = 2048;
  const std::size_t buckets =
    bucketsFor(points_.size(), bucketShift(points_.size(), wantedPoints));
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
    { this->weldItems(items.begin(bucket), items.end(bucket)); },
    executor);
}

/// Finds equal points among items, which stand in the order of the points.
void Weld::weldItems(const Item* first, const Item* last)
{
  // Open addressing, linear probing.
  constexpr std::uint32_t empty = std::numeric_limits<std::uint32_t>::max();
  const auto count = static_cast<std::size_t>(last - first);
  std::size_t size = 16;
  while (size < 2 * count)
  {
    size *= 2;
  }
  std::vector<std::uint32_t> slots(size, empty);
  for (std::size_t i = 0; i < count; ++i)
  {
    const Item& item = first[i];
    // Coordinates are far away, so they are compared only where hashes are equal.
    const auto isEqual = [&](const Item& other)
    {
      return other.hash == item.hash && this->position(other.point) == this->position(item.point);
    };
    std::size_t slot = item.hash & (size - 1);
    while (slots[slot] != empty && !isEqual(first[slots[slot]]))
    {
      slot = (slot + 1) & (size - 1);
    }
    if (slots[slot] == empty)
    {
      slots[slot] = static_cast<std::uint32_t>(i);
    }
    else
    {
      targets_[item.point] = first[slots[slot]].point;
      states_[item.point].store(repeated, std::memory_order_relaxed);
    }
  }
}

} // namespace winding
