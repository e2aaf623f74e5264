// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * operator new of the whole program. A large allocation that fails is thrown as std::bad_alloc: the
 * grid may be too fine or the file damaged, and whoever catches it says so. A small one that fails
 * ends the program at once, with a line and the status for it: memory has run out altogether then,
 * and constructors of VTK crash where an exception passes through them.
 */
#include "program/LastResort.h"

#include <cstdlib>
#include <new>

// The sanitizers have an operator new of their own, which must fit their operator delete.
#ifndef WINDING_SANITIZED

namespace
{

constexpr std::size_t large = std::size_t(1) << 20; // bytes

} // namespace

void* operator new(std::size_t size)
{
  if (void* const block = std::malloc(size > 0 ? size : 1))
  {
    return block;
  }
  if (size < large)
  {
    leaveWithoutMemory();
  }
  throw std::bad_alloc();
}

void operator delete(void* block) noexcept
{
  std::free(block);
}

void operator delete(void* block, std::size_t) noexcept
{
  std::free(block);
}

#endif
