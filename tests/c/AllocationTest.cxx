// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AllCalls.h"

#include <atomic>
#include <cstdlib>
#include <new>

/**
 * @file
 * Every allocation of the library fails once. The program's operator new is the library's, too.
 */
namespace
{

std::atomic<long> allocationsLeft{-1}; // before one fails; less than 0 for never
std::atomic<long> blocks{0};           // that were allocated and not given back

void* allocate(std::size_t size)
{
  if (allocationsLeft >= 0 && allocationsLeft-- == 0)
  {
    throw std::bad_alloc();
  }
  void* const memory = std::malloc(size > 0 ? size : 1);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  ++blocks;
  return memory;
}

void release(void* memory) noexcept
{
  if (memory)
  {
    --blocks;
    std::free(memory);
  }
}

} // namespace

void* operator new(std::size_t size)
{
  return allocate(size);
}

void* operator new[](std::size_t size)
{
  return allocate(size);
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  try
  {
    return allocate(size);
  }
  catch (const std::bad_alloc&)
  {
    return nullptr;
  }
}

void operator delete(void* memory) noexcept
{
  release(memory);
}

void operator delete[](void* memory) noexcept
{
  release(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
  release(memory);
}

void operator delete[](void* memory, std::size_t) noexcept
{
  release(memory);
}

namespace
{

using namespace calls;

/// Makes `work` fail at one allocation after the other, until it passes; at most 300 of them.
/// `work` returns the status, and gives back what it has made. Returns the number of allocations.
template <class Work> long expectNoMemoryEverywhere(const Work& work)
{
  EXPECT_EQ(work(), WINDING_OK); // what is made once for all calls is made
  const long before = blocks;
  allocationsLeft = 1L << 40;
  EXPECT_EQ(work(), WINDING_OK);
  const long count = (1L << 40) - allocationsLeft;
  EXPECT_EQ(blocks, before);
  for (long i = 0; i < count; i += count / 300 + 1)
  {
    allocationsLeft = i;
    const winding_status status = work();
    const bool hasFailed = allocationsLeft < 0;
    allocationsLeft = -1;
    EXPECT_TRUE(status == (hasFailed ? WINDING_NO_MEMORY : WINDING_OK) || status == WINDING_OK)
      << i << " of " << count << ": " << status;
    EXPECT_EQ(blocks, before) << i << " of " << count;
  }
  allocationsLeft = -1;
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
  EXPECT_EQ(allocating, 29) << "all except seven that only look at what there is";
}
