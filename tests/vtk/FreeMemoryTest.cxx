// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/FreeMemory.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include <unistd.h>

namespace
{

using namespace winding;

constexpr double gib = 1024.0 * 1024.0 * 1024.0;

HostMemory tenOfWhichFourAreUsed()
{
  return {10 * gib, 4 * gib};
}

HostMemory moreUsedThanThereIs()
{
  return {gib, 2 * gib};
}

std::string refusalOf(double bytes, HostMemory (*memory)())
{
  try
  {
    refuseBeyondFreeMemory(bytes, "the result", {largerVoxels()}, memory);
    return "";
  }
  catch (const OutOfMemory& refusal)
  {
    return refusal.what();
  }
}

TEST(FreeMemory, UsedMemoryIsNotFree)
{
  EXPECT_EQ(refusalOf(5.9 * gib, tenOfWhichFourAreUsed), "");
  EXPECT_EQ(refusalOf(7 * gib, tenOfWhichFourAreUsed),
    "not enough memory: choose larger voxels; the result needs 7 GiB, and 6 GiB is free");
  EXPECT_EQ(refusalOf(0.5 * gib, moreUsedThanThereIs),
    "not enough memory: choose larger voxels; the result needs 512 MiB, and 0 MiB is free");
}

TEST(FreeMemory, LittleIsNotRefused)
{
  EXPECT_EQ(refusalOf(63.0 * 1024 * 1024, moreUsedThanThereIs), "");
  EXPECT_NE(refusalOf(65.0 * 1024 * 1024, moreUsedThanThereIs), "");
}

TEST(FreeMemory, WhatThisProcessHoldsIsUsed)
{
  constexpr std::size_t held = std::size_t(256) << 20;
  const std::vector<char> block(held, 1);
  double pages = 0;
  std::string size;
  std::ifstream("/proc/self/statm") >> size >> pages;
  const double resident = pages * static_cast<double>(sysconf(_SC_PAGESIZE));
  ASSERT_GT(resident, held) << block.back();
  const HostMemory memory = hostMemory();
  EXPECT_GT(memory.total, memory.used);
  // The files of programs and libraries are resident, too, which the system counts as cached.
  EXPECT_GT(memory.used, held);
}

} // namespace
