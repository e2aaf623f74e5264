#pragma once

#include "Executor.h"

class vtkAlgorithm;

namespace winding
{

/**
 * Runs the core's blocks on vtkSMPTools for a filter. The blocks go out in batches of about a tenth
 * of a second; between batches, on the calling thread, the filter's progress is updated, and
 * before each its abort flag is asked. Which blocks make a batch depends on the clock, what they compute does not.
 */
class SmpExecutor final : public Executor
{
public:
  /// What the filter's progress does during a run. Observers hear of it after every batch in either
  /// case: that is when they can set the abort flag.
  enum class Progress
  {
    goesToOne,
    staysAtZero
  };

  /// threads: the most to use, 0 for as many as vtkSMPTools would; never more than there are cores.
  SmpExecutor(vtkAlgorithm* filter, int threads, Progress progress = Progress::goesToOne);

  bool run(std::size_t count, const std::function<void(std::size_t)>& work) override;

  /// Whether there was anything to do yet.
  bool hasRun() const { return hasRun_; }

private:
  bool runBatches(std::size_t count, const std::function<void(std::size_t)>& work) const;
  void runBatch(
    std::size_t first, std::size_t last, const std::function<void(std::size_t)>& work) const;

  vtkAlgorithm* filter_;
  int threads_;
  Progress progress_;
  bool hasRun_ = false;
};

} // namespace winding
