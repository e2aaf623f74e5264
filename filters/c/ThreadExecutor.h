// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/Stopwatch.h"
#include "winding.h"

#include <functional>
#include <memory>

namespace winding::c
{

/**
 * Runs the core's blocks on threads of its own for one call of the library. The calling thread
 * works, too, and between its blocks calls the caller's progress function. Threads are made where
 * a run would take the calling thread more than a fifth of a millisecond, and end with this object.
 */
class ThreadExecutor final : public Executor
{
public:
  explicit ThreadExecutor(const winding_run& run);
  ~ThreadExecutor() override;
  ThreadExecutor(const ThreadExecutor&) = delete;
  void operator=(const ThreadExecutor&) = delete;

  /// Throws Interrupted where the progress function asks for it.
  void run(std::size_t count, const std::function<void(std::size_t)>& work) override;

  /// Progress stays, but its function is called.
  void runBriefly(std::size_t count, const std::function<void(std::size_t)>& work) override;

  void setShare(double first, double last) override { share_ = {first, last}; }
  std::pair<double, double> share() const override { return share_; }

  /// Hears of seconds since runByClock() began: the `elapsed` ones, and the `expected` ones until
  /// progress is 1.
  using Look = std::function<void(double elapsed, double expected)>;

  /// Does `work`, and calls `look` between blocks of the calling thread. An exception of `look`
  /// ends the run.
  void runByClock(const std::function<void()>& work, const Look& look);

private:
  class Threads;

  void runBlocks(
    std::size_t count, const std::function<void(std::size_t)>& work, bool showsProgress);
  void lookUp(double done, bool showsProgress, Clock::time_point startOfRun);

  winding_run run_;
  std::size_t threadCount_;
  std::unique_ptr<Threads> threads_;
  std::pair<double, double> share_ = {0, 1};
  double progress_ = 0; ///< that was shown last
  Clock::time_point lastCall_;
  Look look_; ///< empty outside of runByClock()
  Clock::time_point start_;
};

} // namespace winding::c
