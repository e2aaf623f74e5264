// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <exception>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace winding
{

/**
 * The seam between the core and whatever runs its work. The core cuts its work into blocks that do
 * not depend on each other and hands them over; threads, progress and interruption are the
 * executor's business. Results never depend on the executor: every block writes its own output.
 */
class Executor
{
public:
  virtual ~Executor() = default;

  /**
   * Calls work(0) … work(count − 1), each once, in any order and on any threads, and returns when
   * all have ended. Throws Interrupted, with some blocks left undone, when interrupted.
   */
  virtual void run(std::size_t count, const std::function<void(std::size_t)>& work) = 0;

  /// Runs preparing work that is brief compared with what a user waits for. Does as run() does,
  /// except that an executor which shows progress leaves its progress where it is.
  virtual void runBriefly(std::size_t count, const std::function<void(std::size_t)>& work)
  {
    this->run(count, work);
  }

  /// Says that the work that runs next is the share from `first` to `last`, from 0 to 1, of all the
  /// work. Only executors that show progress need it.
  virtual void setShare(double first, double last)
  {
    (void)first;
    (void)last;
  }

  /// The share that was set last, 0 and 1 at first. Code that divides its work further sets parts
  /// of this share.
  virtual std::pair<double, double> share() const { return {0, 1}; }
};

/// Runs the blocks one after the other on the calling thread; never interrupted.
class SerialExecutor final : public Executor
{
public:
  void run(std::size_t count, const std::function<void(std::size_t)>& work) override
  {
    for (std::size_t block = 0; block < count; ++block)
    {
      work(block);
    }
  }
};

/// Thrown by executors that were interrupted, through every function that takes one: nothing was
/// made, and arrays that were to be filled hold anything.
class Interrupted final : public std::exception
{
public:
  const char* what() const noexcept override { return "interrupted"; }
};

/**
 * Cuts 0 … count − 1 into blocks of the same size, the last one excepted, and calls
 * work(block, first, last) for each: the items of a block are first … last − 1. The blocks depend
 * on `count` and `itemsPerBlock` only, and are run by runBriefly(). Throws Interrupted.
 */
template <class Work>
void runBlocks(std::size_t count, std::size_t itemsPerBlock, const Work& work, Executor& executor)
{
  executor.runBriefly((count + itemsPerBlock - 1) / itemsPerBlock,
    [&](std::size_t block)
    {
      const std::size_t first = block * itemsPerBlock;
      work(block, first, std::min(count, first + itemsPerBlock));
    });
}

/// Returns the sum of what add(i, sum) adds for the items 0 … count − 1, block by block, so that it
/// has the same bits for any executor. Throws Interrupted.
template <class Add> double sumOverItems(std::size_t count, const Add& add, Executor& executor)
{
  constexpr std::size_t itemsPerBlock = 16384;
  std::vector<double> sums((count + itemsPerBlock - 1) / itemsPerBlock, 0);
  runBlocks(
    count, itemsPerBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        add(i, sums[block]);
      }
    },
    executor);
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

/// Calls work(i) for the items 0 … count − 1, blocks of them at once, as runBlocks() does: for work
/// of much the same size. Throws Interrupted.
template <class Work> void forEachItem(std::size_t count, const Work& work, Executor& executor)
{
  constexpr std::size_t itemsPerBlock = 4096;
  runBlocks(
    count, itemsPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        work(i);
      }
    },
    executor);
}

} // namespace winding
