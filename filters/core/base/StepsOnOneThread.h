#pragma once

#include "base/DividedShare.h"
#include "base/Executor.h"

namespace winding
{

/// Lets an executor show the progress of long work on the calling thread, and interrupt it.
class StepsOnOneThread
{
public:
  StepsOnOneThread(std::size_t steps, Executor& executor)
    : executor_(executor)
    , share_(executor)
    , steps_(steps)
  {
  }

  /// Says that one more step is done. Throws Interrupted.
  void step()
  {
    constexpr std::size_t stepsPerLook = 16384;
    if (++done_ % stepsPerLook != 0)
    {
      return;
    }
    const double part = static_cast<double>(done_) / static_cast<double>(steps_);
    share_.set(part, part);
    executor_.runBriefly(1, [](std::size_t) {});
  }

private:
  Executor& executor_;
  DividedShare share_;
  std::size_t steps_, done_ = 0;
};

} // namespace winding
