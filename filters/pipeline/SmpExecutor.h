// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/Stopwatch.h"

#include "vtkWindingABINamespace.h"

#include <utility>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
VTK_ABI_NAMESPACE_END

namespace winding
{

/**
 * Runs the core's blocks on vtkSMPTools for a filter. The blocks go out in batches of about a tenth
 * of a second; between batches, on the calling thread, the filter's progress is updated, and before
 * each its abort flag is asked. The clock decides which blocks make a batch, but not what they
 * compute. Without a filter (null) there is no progress, and nothing interrupts.
 */
class SmpExecutor final : public Executor
{
public:
  /// `threads` is the largest number to use; 0 leaves it to vtkSMPTools, or shares the cores among
  /// the ranks of a parallel program on this machine. There are never more threads than cores.
  SmpExecutor(vtkAlgorithm* filter, int threads);

  /// Work that comes after this takes progress from `first` to `last`, where it is shown; at first
  /// from 0 to 1.
  void setShare(double first, double last) override;
  std::pair<double, double> share() const override { return {firstShare_, lastShare_}; }

  /// Progress goes to the end of its share.
  void run(std::size_t count, const std::function<void(std::size_t)>& work) override;

  /// Progress stays. Observers hear of it after every batch all the same, for that is when they can
  /// set the abort flag.
  void runBriefly(std::size_t count, const std::function<void(std::size_t)>& work) override;

  /// Hears of seconds since runByClock() began: the `elapsed` ones, and the `expected` ones until
  /// progress is 1, by the clock.
  using Look = std::function<void(double elapsed, double expected)>;

  /// Does `work` on the calling thread, and calls `look` there after each batch of its runs. An
  /// exception of `look` ends the run.
  void runByClock(const std::function<void()>& work, const Look& look);

  /// Whether there was anything to do yet.
  bool hasRun() const { return hasRun_; }

private:
  void runOnBackend(
    std::size_t count, const std::function<void(std::size_t)>& work, bool showsProgress);
  bool runBatches(
    std::size_t count, const std::function<void(std::size_t)>& work, bool showsProgress);
  void checkClock(Clock::time_point startOfRun, double done) const;
  void showProgress(double done, bool showsProgress) const;
  void runBatch(
    std::size_t first, std::size_t last, const std::function<void(std::size_t)>& work) const;

  vtkAlgorithm* filter_;
  int threads_;
  double firstShare_ = 0;
  double lastShare_ = 1;
  bool hasRun_ = false;
  Look look_;               ///< empty outside of runByClock()
  Clock::time_point start_; ///< of look_
};

} // namespace winding
