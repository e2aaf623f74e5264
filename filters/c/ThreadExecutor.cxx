// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ThreadExecutor.h"

#include "base/ExpectedTime.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace winding::c
{

/// Threads that wait for runs.
class ThreadExecutor::Threads
{
public:
  explicit Threads(std::size_t count)
  {
    try
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        threads_.emplace_back([this] { this->waitForRuns(); });
      }
    }
    catch (const std::exception&)
    {
      // The system has no more threads: fewer do the work.
    }
  }

  Threads(const Threads&) = delete;
  void operator=(const Threads&) = delete;

  ~Threads()
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      ends_ = true;
    }
    begins_.notify_all();
    for (std::thread& thread : threads_)
    {
      thread.join();
    }
  }

  /// Runs the blocks from `first` on. Calls between(done) after each block of the calling thread,
  /// with the number of blocks that have been begun. What is thrown ends the run, and comes out.
  template <class Between>
  void run(std::size_t first, std::size_t count, const std::function<void(std::size_t)>& work,
    const Between& between)
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      work_ = &work;
      count_ = count;
      next_ = first;
      failure_ = nullptr;
      atWork_ = threads_.size();
      ++number_;
    }
    begins_.notify_all();
    try
    {
      for (std::size_t block = next_++; block < count; block = next_++)
      {
        work(block);
        between(std::min<std::size_t>(next_, count));
      }
    }
    catch (...)
    {
      this->fail(std::current_exception());
    }
    std::unique_lock<std::mutex> lock(mutex_);
    isDone_.wait(lock, [this] { return atWork_ == 0; });
    if (failure_)
    {
      std::rethrow_exception(std::exchange(failure_, nullptr));
    }
  }

private:
  void fail(std::exception_ptr failure)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    failure_ = failure_ ? failure_ : std::move(failure);
    next_ = count_; // nobody begins with another block
  }

  void waitForRuns()
  {
    std::size_t done = 0;
    for (std::unique_lock<std::mutex> lock(mutex_);;)
    {
      begins_.wait(lock, [this, done] { return ends_ || number_ != done; });
      if (ends_)
      {
        return;
      }
      done = number_;
      const std::size_t count = count_;
      const std::function<void(std::size_t)>& work = *work_;
      lock.unlock();
      try
      {
        for (std::size_t block = next_++; block < count; block = next_++)
        {
          work(block);
        }
      }
      catch (...)
      {
        this->fail(std::current_exception());
      }
      lock.lock();
      if (--atWork_ == 0)
      {
        isDone_.notify_one();
      }
    }
  }

  std::mutex mutex_;
  std::condition_variable begins_, isDone_;
  std::vector<std::thread> threads_;
  const std::function<void(std::size_t)>* work_ = nullptr;
  std::size_t count_ = 0;
  std::size_t number_ = 0; ///< of the run
  std::size_t atWork_ = 0; ///< threads that have not ended with the run
  std::atomic<std::size_t> next_{0};
  std::exception_ptr failure_;
  bool ends_ = false;
};

ThreadExecutor::ThreadExecutor(const winding_run& run)
  : run_(run)
  , threadCount_(std::max(1u, std::thread::hardware_concurrency()))
{
  if (run.number_of_threads > 0)
  {
    threadCount_ = std::min(threadCount_, static_cast<std::size_t>(run.number_of_threads));
  }
}

ThreadExecutor::~ThreadExecutor() = default;

void ThreadExecutor::run(std::size_t count, const std::function<void(std::size_t)>& work)
{
  this->runBlocks(count, work, true);
}

void ThreadExecutor::runBriefly(std::size_t count, const std::function<void(std::size_t)>& work)
{
  this->runBlocks(count, work, false);
}

void ThreadExecutor::runByClock(const std::function<void()>& work, const Look& look)
{
  struct Reset
  {
    Look& look;
    ~Reset() { look = {}; }
  };
  look_ = look;
  const Reset reset{look_};
  start_ = Clock::now();
  work();
}

void ThreadExecutor::runBlocks(
  std::size_t count, const std::function<void(std::size_t)>& work, bool showsProgress)
{
  const Clock::time_point start = Clock::now();
  constexpr double worthThreads = 200e-6; // seconds
  std::size_t block = 0;
  for (; block < count; ++block)
  {
    const double left =
      block == 0 ? 0 : secondsSince(start) * static_cast<double>(count - block) / block;
    if (threadCount_ > 1 && count - block > 1 && left > worthThreads)
    {
      break;
    }
    work(block);
    this->lookUp(static_cast<double>(block + 1) / static_cast<double>(count), showsProgress, start);
  }
  if (block < count)
  {
    if (!threads_)
    {
      threads_ = std::make_unique<Threads>(threadCount_ - 1);
    }
    threads_->run(block, count, work,
      [&](std::size_t done) {
        this->lookUp(static_cast<double>(done) / static_cast<double>(count), showsProgress, start);
      });
  }
}

/// Calls the caller's progress function, if it is time to, and the look of runByClock().
void ThreadExecutor::lookUp(double done, bool showsProgress, Clock::time_point startOfRun)
{
  if (look_)
  {
    const double elapsed = secondsSince(start_), ofRun = secondsSince(startOfRun) / done;
    look_(elapsed, expectedSeconds(elapsed, ofRun, done, share_));
  }
  if (!run_.progress || secondsSince(lastCall_) < run_.interval)
  {
    return;
  }
  if (showsProgress)
  {
    progress_ = std::max(progress_, share_.first + (share_.second - share_.first) * done);
  }
  const bool goesOn = run_.progress(std::min(progress_, 1.0), run_.user) == 0;
  lastCall_ = Clock::now();
  if (!goesOn)
  {
    throw Interrupted();
  }
}

} // namespace winding::c
