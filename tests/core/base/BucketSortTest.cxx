// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/BucketSort.h"

#include "base/Executor.h"
#include "support/Samples.h"
#include "support/Serial.h"
#include "support/ShuffledThreads.h"

#include <gtest/gtest.h>

namespace
{

using namespace shapes;
using winding::Buckets;
using winding::distribute;

struct Item
{
  std::uint32_t bucket, source;

  bool operator==(const Item& other) const
  {
    return bucket == other.bucket && source == other.source;
  }
};

/// Source i emits i % 4 items into random buckets.
std::vector<std::vector<std::uint32_t>> randomTargets(
  std::size_t sources, std::size_t buckets, unsigned seed)
{
  Random random(seed);
  std::vector<std::vector<std::uint32_t>> targets(sources);
  for (std::size_t i = 0; i < sources; ++i)
  {
    for (std::size_t j = 0; j < i % 4; ++j)
    {
      targets[i].push_back(static_cast<std::uint32_t>(random.bits() % buckets));
    }
  }
  return targets;
}

} // namespace

TEST(BucketSort, KeepsTheOrderOfTheSourcesInEveryBucketForAnyExecutor)
{
  SCOPED_TRACE("seeds 151 … 156");
  ShuffledThreads threads(151);
  unsigned seed = 152;
  for (const std::size_t sources : {0, 1, 5, 100000})
  {
    const std::size_t buckets = sources == 5 ? 1 : 37;
    const auto targets = randomTargets(sources, buckets, seed++);
    std::vector<std::vector<Item>> expected(buckets);
    for (std::size_t i = 0; i < sources; ++i)
    {
      for (const std::uint32_t bucket : targets[i])
      {
        expected[bucket].push_back({bucket, static_cast<std::uint32_t>(i)});
      }
    }
    const auto emit = [&](std::size_t first, std::size_t last, const auto& put)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        for (const std::uint32_t bucket : targets[i])
        {
          put(bucket, Item{bucket, static_cast<std::uint32_t>(i)});
        }
      }
    };
    for (winding::Executor* executor : std::initializer_list<winding::Executor*>{&serial, &threads})
    {
      const Buckets<Item> found = distribute<Item>(sources, buckets, emit, *executor);
      ASSERT_EQ(found.count(), buckets);
      for (std::size_t bucket = 0; bucket < buckets; ++bucket)
      {
        ASSERT_EQ(found.size(bucket), expected[bucket].size());
        ASSERT_TRUE(std::equal(found.begin(bucket), found.end(bucket), expected[bucket].begin()));
      }
    }
  }
}

TEST(BucketSort, ShiftsFillNoMoreBucketsThanWanted)
{
  EXPECT_EQ(winding::bucketsFor(0, winding::bucketShift(0, 4096)), 0u);
  EXPECT_EQ(winding::bucketsFor(1, winding::bucketShift(1, 4096)), 1u);
  EXPECT_EQ(winding::bucketsFor(4096, winding::bucketShift(4096, 4096)), 1u);
  EXPECT_EQ(winding::bucketsFor(4097, winding::bucketShift(4097, 4096)), 2u);
  for (const std::size_t size :
    {std::size_t(1000), std::size_t(1) << 22, (std::size_t(1) << 32) + 1})
  {
    const std::size_t buckets = winding::bucketsFor(size, winding::bucketShift(size, 1));
    EXPECT_LE(buckets, winding::mostBuckets);
    EXPECT_GE(buckets, winding::mostBuckets / 2 - 50);
  }
}
