// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/LastResort.h"

#include "program/Failure.h"
#include "program/Interrupt.h"

#include <cstring>
#include <exception>
#include <new>

#include <unistd.h>

namespace
{

void tell(const char* line)
{
  const ssize_t ignored = write(STDERR_FILENO, line, std::strlen(line));
  static_cast<void>(ignored);
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
  interrupt::removeTemporaryFiles();
  tell("winding: error: unexpected end; please report it\n");
  _exit(EXIT_REFUSED);
}

} // namespace

void installLastResort()
{
  std::set_terminate(leave);
}

void leaveWithoutMemory()
{
  interrupt::removeTemporaryFiles();
  tell("winding: error: not enough memory; end other programs, or choose a coarser grid\n");
  _exit(EXIT_NO_MEMORY);
}
