// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A library to be loaded before all others (LD_PRELOAD), which does something to a file at the
 * moment when it is opened. Variables of the environment say what:
 *
 * - FAULT_FILE: a part of the file's name; other files are left alone.
 * - FAULT_OPENING=n: at which opening of such a file, from 1 on.
 * - FAULT_ACTION: unlink or truncate the file (to half its size) before it is opened, touch it,
 *   append to it, alter its last byte but one with its time as before, replace it by FAULT_OTHER,
 *   pause for a second, or hang for a minute.
 * - FAULT_VICTIM: the file to which this happens in its place, if this is set.
 */
#include <atomic>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

namespace
{

void sleepThroughSignals(int seconds)
{
  struct timespec left = {seconds, 0};
  while (nanosleep(&left, &left) != 0)
  {
  }
}

template <class Function> Function next(const char* name)
{
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

using Open = int (*)(const char*, int, ...);
using FileOpen = std::FILE* (*)(const char*, const char*);

void writeInto(const char* path, int flags, const char* text, off_t offset)
{
  const int file = next<Open>("open")(path, O_WRONLY | flags);
  lseek(file, offset, SEEK_SET);
  static_cast<void>(!write(file, text, std::strlen(text)));
  close(file);
}

void disturb(const char* path)
{
  static std::atomic<long> openings{0};
  const char* const part = std::getenv("FAULT_FILE");
  const char* const at = std::getenv("FAULT_OPENING");
  const char* const action = std::getenv("FAULT_ACTION");
  if (!part || !at || !action || !std::strstr(path, part) || ++openings != std::atol(at))
  {
    return;
  }
  if (const char* const victim = std::getenv("FAULT_VICTIM"))
  {
    path = victim;
  }
  struct stat status = {};
  if (std::strcmp(action, "unlink") == 0)
  {
    unlink(path);
  }
  else if (std::strcmp(action, "truncate") == 0 && stat(path, &status) == 0)
  {
    static_cast<void>(!truncate(path, status.st_size / 2));
  }
  else if (std::strcmp(action, "touch") == 0)
  {
    utimensat(AT_FDCWD, path, nullptr, 0);
  }
  else if (std::strcmp(action, "replace") == 0)
  {
    static_cast<void>(std::rename(std::getenv("FAULT_OTHER"), path));
  }
  else if (std::strcmp(action, "append") == 0)
  {
    writeInto(path, O_APPEND, "1,2,3,4\n", 0);
  }
  else if (std::strcmp(action, "alter") == 0 && stat(path, &status) == 0)
  {
    writeInto(path, 0, "?", status.st_size - 2);
    const struct timespec times[] = {status.st_atim, status.st_mtim};
    utimensat(AT_FDCWD, path, times, 0);
  }
  else if (std::strcmp(action, "hang") == 0)
  {
    sleepThroughSignals(60);
  }
  else if (std::strcmp(action, "pause") == 0)
  {
    sleepThroughSignals(1);
  }
}

int openNext(const char* name, const char* path, int flags, va_list arguments)
{
  disturb(path);
  const bool hasMode = (flags & (O_CREAT | O_TMPFILE)) != 0;
  const mode_t mode = hasMode ? va_arg(arguments, mode_t) : 0;
  return next<Open>(name)(path, flags, mode);
}

} // namespace

extern "C"
{

  int open(const char* path, int flags, ...)
  {
    va_list arguments;
    va_start(arguments, flags);
    const int file = openNext("open", path, flags, arguments);
    va_end(arguments);
    return file;
  }

  int open64(const char* path, int flags, ...)
  {
    va_list arguments;
    va_start(arguments, flags);
    const int file = openNext("open64", path, flags, arguments);
    va_end(arguments);
    return file;
  }

  std::FILE* fopen(const char* path, const char* mode)
  {
    disturb(path);
    return next<FileOpen>("fopen")(path, mode);
  }

  std::FILE* fopen64(const char* path, const char* mode)
  {
    disturb(path);
    return next<FileOpen>("fopen64")(path, mode);
  }

} // extern "C"
