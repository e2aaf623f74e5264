// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "program/Stopwatch.h"

#include <algorithm>
#include <memory>

/**
 * @file
 * Times are the least of several runs, since all else that the machine does only adds to them.
 */

/// Seconds that work() takes: the least of up to `runs` runs, fewer where they take more than two
/// seconds together.
template <class Work> double secondsOf(const Work& work, int runs = 5)
{
  double best = 0;
  const Stopwatch all;
  for (int run = 0; run < runs && (run == 0 || all.seconds() < 2); ++run)
  {
    const Stopwatch one;
    work();
    const double seconds = one.seconds();
    best = run == 0 ? seconds : std::min(best, seconds);
  }
  return best;
}

/// Seconds that processors have spent on this program.
double processorSeconds();

/// Processor seconds that one call of work() takes, even if they are a few nanoseconds. Time that
/// other programs take has no part in them.
template <class Work> double secondsOfOne(const Work& work)
{
  const auto secondsOfMany = [&work](std::size_t calls)
  {
    const double start = processorSeconds();
    for (std::size_t i = 0; i < calls; ++i)
    {
      work();
    }
    return processorSeconds() - start;
  };
  constexpr double worthTiming = 2e-4;
  const Stopwatch all;
  std::size_t calls = 1;
  double best = secondsOfMany(calls);
  for (int run = 0; best < worthTiming || (run < 20 && all.seconds() < 0.5); ++run)
  {
    if (best < worthTiming)
    {
      // A busy machine has a clock that ticks coarsely, and a short run may show a stray tick.
      calls *= 2;
      best = secondsOfMany(calls);
      run = 0;
    }
    else
    {
      best = std::min(best, secondsOfMany(calls));
    }
  }
  return best / static_cast<double>(calls);
}

/// An array whose pages are touched for the first time when it is written, as in a program that
/// makes one field.
std::unique_ptr<float[]> freshArray(std::size_t size);

/// Seconds to write a constant to a fresh array of floats, by one thread.
double secondsToFill(std::size_t samples);
