// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/LargePages.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace winding
{

void adviseLargePages(void* memory, std::size_t bytes)
{
#ifdef MADV_HUGEPAGE
  constexpr std::uintptr_t largePage = 2u << 20;
  const auto begin = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t end = begin + bytes;
  const std::uintptr_t first = (begin + largePage - 1) / largePage * largePage;
  if (first + largePage <= end)
  {
    madvise(static_cast<char*>(memory) + (first - begin), end - first, MADV_HUGEPAGE);
  }
#else
  (void)memory;
  (void)bytes;
#endif
}

} // namespace winding
