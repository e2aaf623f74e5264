#pragma once

#include "base/Executor.h"

namespace winding
{

/// Divides what is an executor's share of progress when this is made, and gives that back in the end: so
/// what takes a part may divide it again.
class DividedShare
{
public:
  explicit DividedShare(Executor& executor)
    : executor_(executor)
    , first_(executor.share().first)
    , last_(executor.share().second)
  {
  }
  ~DividedShare() { this->set(0, 1); }
  DividedShare(const DividedShare&) = delete;
  DividedShare& operator=(const DividedShare&) = delete;

  /// What runs next is from `first` to `last` of it, of 0 to 1.
  void set(double first, double last) { executor_.setShare(this->at(first), this->at(last)); }

private:
  double at(double part) const { return first_ + (last_ - first_) * part; }

  Executor& executor_;
  double first_, last_;
};

} // namespace winding
