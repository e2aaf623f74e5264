// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AllCalls.h"

#include "support/FailingAllocations.h"

/// @file Every allocation of the library fails once.
namespace
{

using namespace calls;
using allocations::blocks;

/// Makes `work` fail at one allocation after the other, until it passes; at most 300 of them.
/// `work` returns the status, and gives back what it has made. Returns the number of allocations.
template <class Work> long expectNoMemoryEverywhere(const Work& work)
{
  EXPECT_EQ(work(), WINDING_OK); // what is made once for all calls is made
  const long before = blocks;
  allocations::left = 1L << 40;
  EXPECT_EQ(work(), WINDING_OK);
  const long count = (1L << 40) - allocations::left;
  EXPECT_EQ(blocks, before);
  for (long i = 0; i < count; i += count / 300 + 1)
  {
    allocations::left = i;
    const winding_status status = work();
    const bool hasFailed = allocations::left < 0;
    allocations::left = -1;
    EXPECT_TRUE(status == (hasFailed ? WINDING_NO_MEMORY : WINDING_OK) || status == WINDING_OK)
      << i << " of " << count << ": " << status;
    EXPECT_EQ(blocks, before) << i << " of " << count;
  }
  allocations::left = -1;
  return count;
}

} // namespace

TEST(Allocations, ThatFailEndCallsWithoutALeak)
{
  int allocating = 0;
  for (const Call& call : allCalls)
  {
    SCOPED_TRACE(call.name);
    Arguments arguments;
    arguments.run.number_of_threads = 1;
    const long count = expectNoMemoryEverywhere(
      [&]
      {
        const winding_status status = call.make(arguments);
        if (status != WINDING_OK)
        {
          EXPECT_EQ(arguments.madeField, nullptr);
          EXPECT_EQ(arguments.madeMesh, nullptr);
        }
        arguments.release();
        return status;
      });
    allocating += count > 0 ? 1 : 0;
  }
  EXPECT_EQ(allocating, 36) << "all except seven that only look at what there is";
}
