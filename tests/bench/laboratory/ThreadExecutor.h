// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"

/// Runs the core's blocks on the program's threads, all or some of them, until the program is
/// interrupted.
class ThreadExecutor final : public winding::Executor
{
public:
  /// 0 stands for all threads.
  explicit ThreadExecutor(int threads = 0)
    : threads_(threads)
  {
  }
  void run(std::size_t count, const std::function<void(std::size_t)>& work) override;

private:
  int threads_;
};
