// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/SmpExecutor.h"

#include "base/ExpectedTime.h"
#include "pipeline/HostShare.h"
#include "pipeline/VtkVersions.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>
#include <thread>

namespace winding
{

namespace
{

/// The active backend, or STDThread where Sequential is active though nobody asked for it. Where
/// the environment asks for Sequential, that holds: two threads that choose a backend for their
/// filters at a time may leave VTK with the backend of one of them.
std::string backendToUse()
{
  std::string active = vtkSMPTools::GetBackend();
  const bool isSequential = active == "Sequential";
#if VTK_SMP_DEFAULT_IMPLEMENTATION_SEQUENTIAL && VTK_SMP_ENABLE_STDTHREAD
  const char* asked = std::getenv("VTK_SMP_BACKEND_IN_USE");
  if (asked && std::strcmp(asked, "Sequential") == 0)
  {
    return asked;
  }
  return isSequential ? "STDThread" : active;
#else
  (void)isSequential;
  return active;
#endif
}

/// Returns the backend for a run with a limit of `threads`, or with none for 0. TBB keeps to the
/// lowest limit for ever with VTK 9.6, unlike with 9.3, so STDThread takes runs that have one.
std::string backendFor(int threads)
{
  std::string backend = backendToUse();
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0) && VTK_SMP_ENABLE_STDTHREAD
  if (threads != 0 && backend == "TBB")
  {
    return "STDThread";
  }
#else
  (void)threads;
#endif
  return backend;
}

/// A backend that is active as long as the object lives.
class ActiveBackend
{
public:
  explicit ActiveBackend(const std::string& backend)
    : before_(vtkSMPTools::GetBackend())
  {
    vtkSMPTools::SetBackend(backend.c_str());
  }
  ActiveBackend(const ActiveBackend&) = delete;
  ActiveBackend& operator=(const ActiveBackend&) = delete;
  ~ActiveBackend() { vtkSMPTools::SetBackend(before_.c_str()); }

private:
  std::string before_;
};

constexpr double secondsPerBatch = 0.1;

int cores()
{
  return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

/// The threads that vtkSMPTools takes where nothing else is said.
int availableThreads()
{
  return backendToUse() == vtkSMPTools::GetBackend()
           ? std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads())
           : cores();
}

} // namespace

SmpExecutor::SmpExecutor(vtkAlgorithm* filter, int threads)
  : filter_(filter)
  , threads_(threads == 0 && ranksOnHost() > 1
               ? std::clamp(cores() / ranksOnHost(), 1, availableThreads())
               : std::min(threads, cores()))
{
}

void SmpExecutor::runBatch(
  std::size_t first, std::size_t last, const std::function<void(std::size_t)>& work) const
{
  // Some pieces per thread even out the load; one block each would drown small blocks in overhead.
  const std::size_t grain = std::max<std::size_t>(1, (last - first) / 64);
  // Nothing is thrown into a backend: STDThread ends the program, or goes on without the block.
  std::exception_ptr failure;
  std::atomic<bool> hasFailed{false};
  vtkSMPTools::For(static_cast<vtkIdType>(first), static_cast<vtkIdType>(last),
    static_cast<vtkIdType>(grain),
    [&](vtkIdType begin, vtkIdType end)
    {
      try
      {
        for (vtkIdType block = begin; block < end && !hasFailed; ++block)
        {
          work(static_cast<std::size_t>(block));
        }
      }
      catch (...)
      {
        if (!hasFailed.exchange(true))
        {
          failure = std::current_exception();
        }
      }
    });
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}

bool SmpExecutor::runBatches(
  std::size_t count, const std::function<void(std::size_t)>& work, bool showsProgress)
{
  Clock::time_point startOfRun = Clock::now();
  std::size_t batch =
    static_cast<std::size_t>(std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads()));
  for (std::size_t done = 0; done < count;)
  {
    if (filter_ && isAborted(filter_))
    {
      return false;
    }
    const std::size_t last = std::min(count, done + batch);
    const Clock::time_point start = Clock::now();
    this->runBatch(done, last, work);
    const double seconds = secondsSince(start);
    done = last;
    const double wanted = static_cast<double>(batch) * secondsPerBatch / std::max(seconds, 1e-6);
    batch = static_cast<std::size_t>(std::clamp(wanted, 1.0, 8.0 * static_cast<double>(batch)));
    const double part = static_cast<double>(done) / static_cast<double>(count);
    if (look_)
    {
      const Clock::time_point startOfLook = Clock::now();
      this->checkClock(startOfRun, part);
      // Waiting for other ranks is no work.
      const Clock::duration waited = Clock::now() - startOfLook;
      start_ += waited;
      startOfRun += waited;
    }
    if (filter_)
    {
      this->showProgress(part, showsProgress);
    }
  }
  return true;
}

/// Calls look_ when a part `done` of a run is done.
void SmpExecutor::checkClock(Clock::time_point startOfRun, double done) const
{
  const double elapsed = secondsSince(start_), ofRun = secondsSince(startOfRun) / done;
  look_(elapsed, expectedSeconds(elapsed, ofRun, done, this->share()));
}

void SmpExecutor::runByClock(const std::function<void()>& work, const Look& look)
{
  look_ = look;
  start_ = Clock::now();
  try
  {
    work();
  }
  catch (...)
  {
    look_ = {};
    throw;
  }
  look_ = {};
}

void SmpExecutor::showProgress(double done, bool showsProgress) const
{
  if (showsProgress)
  {
    filter_->UpdateProgress(firstShare_ + (lastShare_ - firstShare_) * done);
    return;
  }
  // UpdateProgress() would shift and scale once more what the filter has shifted and scaled.
  double progress = filter_->GetProgress();
  filter_->InvokeEvent(vtkCommand::ProgressEvent, &progress);
}

void SmpExecutor::run(std::size_t count, const std::function<void(std::size_t)>& work)
{
  this->runOnBackend(count, work, true);
}

void SmpExecutor::runBriefly(std::size_t count, const std::function<void(std::size_t)>& work)
{
  this->runOnBackend(count, work, false);
}

void SmpExecutor::setShare(double first, double last)
{
  firstShare_ = first;
  lastShare_ = last;
}

/// Nothing is thrown within the scope of a backend, which has to be left in order.
void SmpExecutor::runOnBackend(
  std::size_t count, const std::function<void(std::size_t)>& work, bool showsProgress)
{
  hasRun_ = true;
  bool isComplete = false;
  std::exception_ptr failure;
  const auto runAll = [&]()
  {
    try
    {
      isComplete = this->runBatches(count, work, showsProgress);
    }
    catch (...)
    {
      failure = std::current_exception();
    }
  };
  const std::string backend = backendFor(threads_);
  if (threads_ == 0 && backend == vtkSMPTools::GetBackend())
  {
    runAll();
  }
  else
  {
    // A scope gives its limit to the active backend, and changes the backend after that.
    const ActiveBackend active(backend);
    const int before = vtkSMPTools::GetEstimatedNumberOfThreads();
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads_, backend, false), runAll);
    // The limit of a scope outlives the scope with TBB (VTK 9.1).
    if (vtkSMPTools::GetEstimatedNumberOfThreads() != before)
    {
      vtkSMPTools::Initialize(before);
    }
  }
  if (failure)
  {
    std::rethrow_exception(failure);
  }
  if (!isComplete)
  {
    throw Interrupted();
  }
}

} // namespace winding
