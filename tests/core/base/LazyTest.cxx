// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/Lazy.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <stdexcept>
#include <thread>
#include <vector>

namespace
{

using winding::Lazy;

TEST(Lazy, MakesOneValueForAllThreads)
{
  const Lazy<std::vector<int>> numbers;
  std::atomic<int> made{0}, right{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i)
  {
    threads.emplace_back(
      [&]
      {
        const std::vector<int>& found = numbers.get(
          [&]
          {
            ++made;
            std::this_thread::yield();
            return std::vector<int>(1000, 7);
          });
        right += found == std::vector<int>(1000, 7) ? 1 : 0;
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(made, 1);
  EXPECT_EQ(right, 8);
}

TEST(Lazy, TriesAgainWhereMakingThrew)
{
  const Lazy<int> number;
  EXPECT_THROW(number.get([]() -> int { throw std::bad_alloc(); }), std::bad_alloc);
  EXPECT_EQ(number.get([] { return 3; }), 3);
  EXPECT_EQ(number.get([]() -> int { throw std::runtime_error("made before"); }), 3);
}

} // namespace
