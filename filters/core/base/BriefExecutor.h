#pragma once

#include "base/Executor.h"

namespace winding
{

/// Runs all work of another executor briefly, so that none of it shows progress.
class BriefExecutor final : public Executor
{
public:
  explicit BriefExecutor(Executor& executor)
    : executor_(executor)
  {
  }
  void run(std::size_t count, const std::function<void(std::size_t)>& work) override
  {
    executor_.runBriefly(count, work);
  }

private:
  Executor& executor_;
};

} // namespace winding
