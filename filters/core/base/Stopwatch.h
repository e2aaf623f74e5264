#pragma once

#include <chrono>

namespace winding
{

/// Sets a number to the seconds that this object has lived, when it ends.
class Stopwatch
{
public:
  explicit Stopwatch(double& seconds)
    : seconds_(seconds)
  {
  }
  ~Stopwatch() { seconds_ = std::chrono::duration<double>(Clock::now() - start_).count(); }

  Stopwatch(const Stopwatch&) = delete;
  void operator=(const Stopwatch&) = delete;

private:
  using Clock = std::chrono::steady_clock;

  double& seconds_;
  Clock::time_point start_ = Clock::now();
};

} // namespace winding
