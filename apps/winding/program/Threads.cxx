// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/Threads.h"

#include "vtkSMPTools.h"

#include <algorithm>
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
