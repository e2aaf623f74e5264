// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/OrderedBlocks.h"

#include <atomic>
#include <exception>
#include <mutex>

namespace winding
{

void runOrderedBlocks(
  std::size_t count, const std::function<void(std::size_t)>& work, Executor& executor)
{
  std::atomic<std::size_t> firstFailed{count};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto runBlock = [&](std::size_t block)
  {
    if (block > firstFailed)
    {
      return;
    }
    try
    {
      work(block);
    }
    catch (...)
    {
      const std::lock_guard<std::mutex> lock(mutex);
      if (block < firstFailed)
      {
        firstFailed = block;
        failure = std::current_exception();
      }
    }
  };
  try
  {
    executor.run(count, runBlock);
  }
  catch (const Interrupted&)
  {
    if (!failure)
    {
      throw;
    }
  }
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}

} // namespace winding
