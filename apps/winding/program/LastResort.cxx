// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/LastResort.h"

#include "program/Failure.h"
#include "program/Interrupt.h"

#include <atomic>
#include <cstring>
#include <exception>
#include <new>

#include <unistd.h>

namespace
{

/// Writes a line and leaves, in the first thread that comes; others wait for that.
[[noreturn]] void leaveWith(const char* line, int status)
{
  static std::atomic_flag isLeaving = ATOMIC_FLAG_INIT;
  while (isLeaving.test_and_set())
  {
    pause();
  }
  interrupt::removeTemporaryFiles();
  const ssize_t ignored = write(STDERR_FILENO, line, std::strlen(line));
  static_cast<void>(ignored);
  _exit(status);
}

bool hasMemoryRunOut()
{
  try
  {
    if (const std::exception_ptr error = std::current_exception())
    {
      std::rethrow_exception(error);
    }
    return false;
  }
  catch (const std::bad_alloc&)
  {
    return true;
  }
  catch (...)
  {
    return false;
  }
}

[[noreturn]] void leave()
{
  if (hasMemoryRunOut())
  {
    leaveWithoutMemory();
  }
  leaveWith("winding: error: unexpected end; please report it\n", EXIT_REFUSED);
}

} // namespace

void installLastResort()
{
  std::set_terminate(leave);
}

void leaveWithoutMemory()
{
  leaveWith("winding: error: not enough memory; end other programs, or choose a coarser grid\n",
    EXIT_NO_MEMORY);
}
