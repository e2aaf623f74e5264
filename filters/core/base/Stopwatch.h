// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace winding
{

using Clock = std::chrono::steady_clock;

/// Returns the seconds that have passed since `start`.
inline double secondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Sets a number to the seconds that this object has lived, when it ends.
class Stopwatch
{
public:
  explicit Stopwatch(double& seconds)
    : seconds_(seconds)
  {
  }
  ~Stopwatch() { seconds_ = secondsSince(start_); }

  Stopwatch(const Stopwatch&) = delete;
  void operator=(const Stopwatch&) = delete;

private:
  double& seconds_;
  Clock::time_point start_ = Clock::now();
};

} // namespace winding
