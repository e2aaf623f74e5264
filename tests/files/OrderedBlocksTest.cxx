// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/Interruption.h"
#include "support/ShuffledThreads.h"

#include "files/OrderedBlocks.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

using namespace winding;

namespace
{

/// The message that comes out where all blocks from 3 on throw their number.
std::string failureOf(Executor& executor)
{
  const auto work = [](std::size_t block)
  {
    if (block >= 3)
    {
      throw std::runtime_error(std::to_string(block));
    }
  };
  try
  {
    runOrderedBlocks(50, work, executor);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "";
}

TEST(OrderedBlocks, TheFirstFailureInOrderComesOut)
{
  SerialExecutor serial;
  EXPECT_EQ(failureOf(serial), "3");
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    shapes::ShuffledThreads threads(seed);
    EXPECT_EQ(failureOf(threads), "3");
  }
}

TEST(OrderedBlocks, AllRunWhereNoneFails)
{
  shapes::ShuffledThreads threads(1);
  std::vector<int> runs(1000);
  runOrderedBlocks(
    runs.size(), [&runs](std::size_t block) { ++runs[block]; }, threads);
  EXPECT_EQ(runs, std::vector<int>(1000, 1));
}

TEST(OrderedBlocks, TellWhenTheyWereInterrupted)
{
  shapes::Interruption executor(0);
  EXPECT_THROW(runOrderedBlocks(
                 3, [](std::size_t) {}, executor),
    Interrupted);
}

} // namespace
