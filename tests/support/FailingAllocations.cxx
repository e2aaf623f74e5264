// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/FailingAllocations.h"

#include <cstdlib>
#include <new>

namespace allocations
{

std::atomic<long> left{-1};
std::atomic<long> blocks{0};
thread_local bool neverFails = false;

} // namespace allocations

namespace
{

void* allocate(std::size_t size)
{
  if (!allocations::neverFails && allocations::left >= 0 && allocations::left-- == 0)
  {
    throw std::bad_alloc();
  }
  void* const memory = std::malloc(size > 0 ? size : 1);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  ++allocations::blocks;
  return memory;
}

void release(void* memory) noexcept
{
  if (memory)
  {
    --allocations::blocks;
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
