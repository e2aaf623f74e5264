#include "program/Threads.h"

#include "program/Interrupt.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace
{

/// More threads than processors gain nothing, and TBB complains of them or crashes.
int atMostTheProcessors(int threads)
{
  const unsigned int processors = std::max(1u, std::thread::hardware_concurrency());
  return std::min(threads, static_cast<int>(processors));
}

} // namespace

void limitThreads(int threads)
{
  if (threads > 0)
  {
    vtkSMPTools::Initialize(atMostTheProcessors(threads));
  }
}

int threadsUsed(int threads)
{
  return threads > 0 ? atMostTheProcessors(threads) : vtkSMPTools::GetEstimatedNumberOfThreads();
}

void runOnThreads(std::size_t count, const std::function<void(std::size_t)>& work)
{
  // Exceptions that leave a thread would end the program.
  std::exception_ptr thrown;
  std::atomic<std::size_t> lowest{count}; // of the numbers that threw
  std::mutex mutex;
  vtkSMPTools::For(0, static_cast<vtkIdType>(count), 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (auto i = static_cast<std::size_t>(first);
           i < static_cast<std::size_t>(last) && i < lowest && !interrupt::requested(); ++i)
      {
        try
        {
          work(i);
        }
        catch (...)
        {
          const std::lock_guard<std::mutex> lock(mutex);
          if (i < lowest)
          {
            lowest = i;
            thrown = std::current_exception();
          }
        }
      }
    });
  interrupt::check();
  if (thrown)
  {
    std::rethrow_exception(thrown);
  }
}
