// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "support/Samples.h"

#include <atomic>
#include <numeric>
#include <thread>
#include <utility>
#include <vector>

namespace shapes
{

/// Runs the blocks on several threads in a shuffled order.
class ShuffledThreads final : public winding::Executor
{
public:
  explicit ShuffledThreads(unsigned seed)
    : seed_(seed)
  {
  }

  void run(std::size_t count, const std::function<void(std::size_t)>& work) override
  {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), 0);
    Random random(seed_);
    for (std::size_t i = count; i > 1; --i)
    {
      std::swap(order[i - 1], order[random.bits() % i]);
    }
    std::atomic<std::size_t> next{0};
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
    {
      threads.emplace_back(
        [&]
        {
          for (std::size_t n = next++; n < count; n = next++)
          {
            work(order[n]);
          }
        });
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
  }

private:
  unsigned seed_;
};

} // namespace shapes
