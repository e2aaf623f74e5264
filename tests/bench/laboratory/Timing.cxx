// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "laboratory/Timing.h"

#include "program/Interrupt.h"

#include <ctime>

#ifdef __GLIBC__
#include <malloc.h>
#endif

double processorSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

std::unique_ptr<float[]> freshArray(std::size_t size)
{
#ifdef __GLIBC__
  // Memory that was freed before, and has been touched, would be used again otherwise.
  malloc_trim(0);
#endif
  return std::unique_ptr<float[]>(new float[size]);
}

double secondsToFill(std::size_t samples)
{
  double best = 0;
  for (int run = 0; run < 5; ++run)
  {
    const std::unique_ptr<float[]> values = freshArray(samples);
    const auto fill = [&]
    {
      std::fill_n(values.get(), samples, 1.0f);
      volatile float* written = values.get(); // else the compiler could leave the array out
      written[samples / 2] = 0;
    };
    const double seconds = secondsOf(fill, 1);
    best = run == 0 ? seconds : std::min(best, seconds);
    interrupt::check();
  }
  return best;
}
