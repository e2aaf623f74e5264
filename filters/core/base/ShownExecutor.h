#pragma once

#include "base/Executor.h"

#include <algorithm>

namespace winding
{

/**
 * Shows the progress of work that runs briefly elsewhere, where it takes long after all. Progress
 * never goes back within the share that the executor has when this object is made: each brief run
 * takes half of what is left of the share set last, so that there may be any number of them, and
 * other runs take all that is left. The executor's share is restored in the end.
 */
class ShownExecutor final : public Executor
{
public:
  explicit ShownExecutor(Executor& executor)
    : executor_(executor)
    , whole_(executor.share())
    , at_(whole_.first)
    , last_(whole_.second)
  {
  }
  ~ShownExecutor() override { executor_.setShare(whole_.first, whole_.second); }
  ShownExecutor(const ShownExecutor&) = delete;
  ShownExecutor& operator=(const ShownExecutor&) = delete;

  void run(std::size_t count, const std::function<void(std::size_t)>& work) override
  {
    this->runUpTo(last_, count, work);
  }
  void runBriefly(std::size_t count, const std::function<void(std::size_t)>& work) override
  {
    this->runUpTo(at_ + (last_ - at_) / 2, count, work);
  }
  void setShare(double first, double last) override
  {
    at_ = std::max(at_, first);
    last_ = std::max(at_, last);
  }
  std::pair<double, double> share() const override { return {at_, last_}; }

private:
  void runUpTo(double next, std::size_t count, const std::function<void(std::size_t)>& work)
  {
    executor_.setShare(at_, next);
    at_ = next;
    executor_.run(count, work);
  }

  Executor& executor_;
  const std::pair<double, double> whole_;
  double at_, last_;
};

} // namespace winding
