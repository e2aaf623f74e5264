// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <mutex>

namespace winding
{

/**
 * A value that is made when it is first asked for, by one thread while others wait for it. Where
 * making throws, the next thread that asks tries again.
 *
 * Takes no thread-local memory, as std::call_once does: glibc ends the process where a library was
 * loaded late and a thread finds no memory for that.
 */
template <class Value> class Lazy
{
public:
  /// Returns the value, which `make()` returned to the first call that did not throw.
  template <class Make> const Value& get(const Make& make) const
  {
    if (!isMade_.load(std::memory_order_acquire))
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!isMade_.load(std::memory_order_relaxed))
      {
        value_ = make();
        isMade_.store(true, std::memory_order_release);
      }
    }
    return value_;
  }

private:
  mutable std::mutex mutex_;
  mutable std::atomic<bool> isMade_{false};
  mutable Value value_ = {};
};

} // namespace winding
