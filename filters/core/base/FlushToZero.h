// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#if defined(__SSE__) || defined(_M_X64)
#define WINDING_HAS_MXCSR
#include <xmmintrin.h>
#endif

namespace winding
{

/**
 * Makes numbers too small for full precision count as 0 in this thread, for as long as the object
 * lives: processors take a hundred times as long over such numbers, and the high degrees of far
 * sources are full of them. Does nothing where the processor lacks the mode.
 */
class FlushToZero
{
public:
  FlushToZero(const FlushToZero&) = delete;
  FlushToZero& operator=(const FlushToZero&) = delete;

#ifdef WINDING_HAS_MXCSR
  FlushToZero()
    : before_(_mm_getcsr())
  {
    constexpr unsigned flushResults = 0x8000, readAsZero = 0x0040;
    _mm_setcsr(before_ | flushResults | readAsZero);
  }
  ~FlushToZero()
  {
    _mm_setcsr(before_);
  }

private:
  unsigned before_;
#else
  FlushToZero() = default;
#endif
};

} // namespace winding
