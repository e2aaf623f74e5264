// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

/// Measures wall-clock time from the moment when it is made.
class Stopwatch
{
public:
  /// Returns the seconds since the start.
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point start_ = Clock::now();
};
