// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"

#include <algorithm>

/**
 * @file
 * Progress, which executors show as the share of all work that is done. Progress divides an
 * executor's share among steps; the executors here show less or more than another one does.
 */
namespace winding
{

/// Divides the share that an executor has when this object is made, and restores it in the end:
/// work that is given a part may divide the part again.
class Progress
{
public:
  explicit Progress(Executor& executor)
    : executor_(executor)
    , whole_(executor.share())
  {
  }
  ~Progress() { executor_.setShare(whole_.first, whole_.second); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Says that the work that runs next is the part from `first` to `last` of the share, 0 to 1.
  void set(double first, double last) { executor_.setShare(this->at(first), this->at(last)); }

  /// Says that `done` of `all` steps on the calling thread are over, and now and then lets the
  /// executor show that, and interrupt. Throws Interrupted.
  void step(std::size_t done, std::size_t all)
  {
    constexpr std::size_t stepsPerLook = 16384;
    if (done % stepsPerLook == 0)
    {
      const double part = static_cast<double>(done) / static_cast<double>(all);
      this->set(part, part);
      executor_.runBriefly(1, [](std::size_t) {});
    }
  }

private:
  double at(double part) const { return whole_.first + (whole_.second - whole_.first) * part; }

  Executor& executor_;
  const std::pair<double, double> whole_;
};

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

/**
 * Shows the progress of another executor's brief work, too, where it takes long after all. Progress
 * never goes back within the share that the executor has when this object is made: each brief run
 * takes half of what is left of the share set last, so that there may be any number of them, and
 * other runs take all that is left. The executor's share is restored in the end.
 */
class ShownExecutor final : public Executor
{
public:
  explicit ShownExecutor(Executor& executor)
    : executor_(executor)
    , progress_(executor)
    , at_(executor.share().first)
    , last_(executor.share().second)
  {
  }
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
  const Progress progress_; ///< restores the share
  double at_, last_;
};

} // namespace winding
