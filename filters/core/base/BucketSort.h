// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/UninitializedVector.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace winding
{

/// Items in memory, bucket after bucket.
template <class Item> class Buckets
{
public:
  Buckets() = default;
  /// starts[b] … starts[b + 1] − 1 are the items of bucket b.
  Buckets(UninitializedVector<Item> items, std::vector<std::size_t> starts)
    : items_(std::move(items))
    , starts_(std::move(starts))
  {
  }
  Buckets(Buckets&&) noexcept = default;
  Buckets& operator=(Buckets&&) noexcept = default;

  std::size_t count() const { return starts_.empty() ? 0 : starts_.size() - 1; }
  std::size_t size(std::size_t bucket) const { return starts_[bucket + 1] - starts_[bucket]; }
  const Item* begin(std::size_t bucket) const { return items_.data() + starts_[bucket]; }
  const Item* end(std::size_t bucket) const { return items_.data() + starts_[bucket + 1]; }
  Item* begin(std::size_t bucket) { return items_.data() + starts_[bucket]; }
  Item* end(std::size_t bucket) { return items_.data() + starts_[bucket + 1]; }

private:
  UninitializedVector<Item> items_;
  std::vector<std::size_t> starts_;
};

/// The most buckets that distribute() fills well: each is a place in memory that is written to in
/// turn, and beyond a thousand of them the caches for addresses are too small.
constexpr std::size_t mostBuckets = 1024;

/// The shift that puts the numbers 0 … size − 1 into buckets of at least `wanted` each, and of more
/// if there were more than `most` buckets otherwise: bucket = i >> shift, which keeps their order.
inline int bucketShift(std::size_t size, std::size_t wanted, std::size_t most = mostBuckets)
{
  int shift = 0;
  while ((std::size_t(1) << shift) < wanted || size >> shift >= most)
  {
    ++shift;
  }
  return shift;
}

/// The number of buckets that i >> shift takes 0 … size − 1 to; none if size is 0.
inline std::size_t bucketsFor(std::size_t size, int shift)
{
  return size > 0 ? ((size - 1) >> shift) + 1 : 0;
}

/**
 * The first pass of a radix sort, in parallel: puts what the sources 0 … sources − 1 emit into
 * buckets. Every block of sources counts what it has for each bucket; sums of the counts say where
 * each block writes in each bucket; then the blocks write. No two blocks write to the same place,
 * so neither locks nor atomics are needed.
 *
 * emit(first, last, put) calls put(bucket, item), any number of times, for the sources
 * first … last − 1 in their order. It is called twice for the same sources, at first with a put
 * that only counts, and must emit the same both times; it may be called from several threads.
 *
 * Guaranteed: stable, that is, in every bucket the items stand in the order of their sources, for
 * any executor. Item must be trivially destructible. Memory is 8 bytes per block of sources and
 * bucket, in addition to the items: choose larger blocks for many buckets, smaller ones where a
 * source takes long. Throws Interrupted.
 */
template <class Item, class Emit>
Buckets<Item> distribute(std::size_t sources, std::size_t buckets, const Emit& emit,
  Executor& executor, std::size_t sourcesPerBlock = 16384)
{
  const std::size_t blocks = (sources + sourcesPerBlock - 1) / sourcesPerBlock;
  std::vector<std::size_t> places(blocks * buckets, 0);
  runBlocks(
    sources, sourcesPerBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      std::size_t* const counts = places.data() + block * buckets;
      emit(first, last, [counts](std::size_t bucket, const Item&) { ++counts[bucket]; });
    },
    executor);

  // Both loops go row by row: column by column they would visit memory in long strides.
  std::vector<std::size_t> starts(buckets + 1, 0);
  for (std::size_t i = 0; i < places.size(); i += buckets)
  {
    for (std::size_t bucket = 0; bucket < buckets; ++bucket)
    {
      starts[bucket + 1] += places[i + bucket];
    }
  }
  for (std::size_t bucket = 0; bucket < buckets; ++bucket)
  {
    starts[bucket + 1] += starts[bucket];
  }
  std::vector<std::size_t> next(starts.begin(), starts.end() - 1);
  for (std::size_t i = 0; i < places.size(); i += buckets)
  {
    for (std::size_t bucket = 0; bucket < buckets; ++bucket)
    {
      const std::size_t count = places[i + bucket];
      places[i + bucket] = next[bucket];
      next[bucket] += count;
    }
  }

  UninitializedVector<Item> items(starts.back());
  runBlocks(
    sources, sourcesPerBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      std::size_t* const place = places.data() + block * buckets;
      emit(first, last,
        [place, to = items.data()](std::size_t bucket, const Item& item)
        { to[place[bucket]++] = item; });
    },
    executor);
  return {std::move(items), std::move(starts)};
}

} // namespace winding
