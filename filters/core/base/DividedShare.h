#pragma once

#include "base/Executor.h"

namespace winding
{

/// Divides the share of progress that an executor has when this object is made, and restores that
/// share when it is destroyed: so work that is given a part may divide the part again.
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

  /// The work that runs next is the part from `first` to `last` of the divided share, from 0 to 1.
  void set(double first, double last) { executor_.setShare(this->at(first), this->at(last)); }

private:
  double at(double part) const { return first_ + (last_ - first_) * part; }

  Executor& executor_;
  double first_, last_;
};

} // namespace winding
