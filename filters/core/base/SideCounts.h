// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/InsideRule.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>

namespace winding
{

/// The samples that are inside by a rule, and those where w is −threshold or less: they would be
/// inside by InsideRule::signedThreshold if all faces or normals were turned round.
struct SideCounts
{
  std::size_t samples = 0;
  std::size_t inside = 0;
  std::size_t negative = 0;
  std::size_t several = 0; ///< samples in more than one solid: w is more than 1.5

  /// Counts one more value `times` times. A threshold of 0 or less has no other side.
  void add(double value, const InsideTest& isInside, std::size_t times = 1)
  {
    samples += times;
    inside += isInside(value) ? times : 0;
    negative += isInside.threshold > 0 && value <= -isInside.threshold ? times : 0;
    several += value > 1.5 ? times : 0;
  }

  SideCounts& operator+=(const SideCounts& other)
  {
    samples += other.samples;
    inside += other.inside;
    negative += other.negative;
    several += other.several;
    return *this;
  }
};

/// Counts about 100 000 of the `values` values, evenly spread over them, or all where there are
/// fewer.
template <class ValueAt>
SideCounts countSides(std::size_t values, double threshold, const ValueAt& valueAt)
{
  constexpr std::size_t most = 100'000;
  const std::size_t step = values / most + 1;
  SideCounts counts;
  for (std::size_t i = 0; i < values; i += step)
  {
    counts.add(valueAt(i), {InsideRule::signedThreshold, threshold});
  }
  return counts;
}

/// Adds up what any number of threads count at once. Threads do not wait for each other: a few
/// share a place at most. No thread needs memory for that.
class SideTally
{
public:
  void add(const SideCounts& counts)
  {
    if (counts.inside > 0 || counts.negative > 0)
    {
      Place& own =
        places_[std::hash<std::thread::id>()(std::this_thread::get_id()) % places_.size()];
      own.inside.fetch_add(counts.inside, std::memory_order_relaxed);
      own.negative.fetch_add(counts.negative, std::memory_order_relaxed);
      own.several.fetch_add(counts.several, std::memory_order_relaxed);
    }
  }

  /// Returns the sums over all threads, of `samples` samples.
  SideCounts counts(std::size_t samples) const
  {
    SideCounts sums;
    sums.samples = samples;
    for (const Place& place : places_)
    {
      sums.inside += place.inside;
      sums.negative += place.negative;
      sums.several += place.several;
    }
    return sums;
  }

private:
  struct alignas(64) Place // a line of the cache
  {
    std::atomic<std::size_t> inside{0};
    std::atomic<std::size_t> negative{0};
    std::atomic<std::size_t> several{0};
  };

  std::array<Place, 64> places_;
};

} // namespace winding
