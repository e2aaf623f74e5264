// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "laboratory/ThreadExecutor.h"

#include "program/Interrupt.h"

#include "vtkSMPTools.h"

#include <algorithm>

void ThreadExecutor::run(std::size_t count, const std::function<void(std::size_t)>& work)
{
  const vtkIdType last = static_cast<vtkIdType>(count);
  const auto workOn = [&work](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType block = begin; block < end && !interrupt::requested(); ++block)
    {
      work(static_cast<std::size_t>(block));
    }
  };
  const auto onThreads = [&]
  {
    vtkSMPTools::For(0, last, std::max<vtkIdType>(1, last / 256), workOn);
  };
  if (threads_ == 1)
  {
    workOn(0, last); // no thread but the caller's, and nothing to start
  }
  else if (threads_ == 0)
  {
    onThreads();
  }
  else
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads_), onThreads);
  }
  if (interrupt::requested())
  {
    throw winding::Interrupted();
  }
}
