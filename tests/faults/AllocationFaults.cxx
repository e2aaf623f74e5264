// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A library to be loaded before all others (LD_PRELOAD), which lets allocations fail. Allocations
 * are counted from 1 on when main() begins. Variables of the environment say what to do:
 *
 * - FAULT_ALLOCATION=n: allocation n fails.
 * - FAULT_ALLOCATIONS_FROM=n: allocation n and all after it fail.
 * - FAULT_SITES=file: none fails; the file gets a line with the number of each allocation that
 *   comes by a way through the program by which none came before.
 *
 * operator new comes here, too, since it calls malloc(). Two kinds of allocations never fail, for
 * those who ask for them do not look whether they got their few bytes, and would crash: that of the
 * constructor of vtkCellArray (VTK 9.1), and dlopen()'s, with which TBB looks for a library
 * that need not be there: glibc 2.36 then writes down an error where it has no memory for it.
 */
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <unistd.h>

// The names are the C library's. NOLINTBEGIN(bugprone-reserved-identifier, readability-*)
extern "C"
{
  void* __libc_malloc(std::size_t size);
  void* __libc_calloc(std::size_t count, std::size_t size);
  void* __libc_realloc(void* block, std::size_t size);
  void* __libc_memalign(std::size_t alignment, std::size_t size);
}
// NOLINTEND(bugprone-reserved-identifier, readability-*)

namespace
{

std::atomic<bool> isCounting{false};
std::atomic<long> counter{0};
long failing = 0;
long failingFrom = 0;
int sites = -1;
thread_local bool isInside = false;

using Main = int (*)(int, char**, char**);
Main realMain = nullptr;

/// Whether no allocation has come by this way before, as far as the nearest callers tell.
bool isNewSite()
{
  constexpr int depth = 14;
  constexpr std::size_t slots = 1 << 20;
  static std::atomic<std::size_t> seen[slots];
  void* callers[depth];
  const int found = backtrace(callers, depth);
  std::size_t hash = 14695981039346656037u;
  for (int i = 0; i < found; ++i)
  {
    hash = (hash ^ reinterpret_cast<std::size_t>(callers[i])) * 1099511628211u;
  }
  for (std::size_t slot = hash % slots;; slot = (slot + 1) % slots)
  {
    std::size_t expected = 0;
    if (seen[slot].compare_exchange_strong(expected, hash))
    {
      return true;
    }
    if (expected == hash)
    {
      return false;
    }
  }
}

bool isFromCellArray(void* caller)
{
  Dl_info found = {};
  return dladdr(caller, &found) != 0 && found.dli_sname &&
         std::strncmp(found.dli_sname, "_ZN12vtkCellArrayC", 18) == 0;
}

/// Whether an allocation, which is asked for by this caller, is to fail. Counts it.
bool fails(void* caller)
{
  if (!isCounting || isInside)
  {
    return false;
  }
  const long number = ++counter;
  if (sites >= 0)
  {
    isInside = true;
    if (isNewSite())
    {
      char line[32];
      const int size = std::snprintf(line, sizeof line, "%ld\n", number);
      static_cast<void>(!write(sites, line, static_cast<std::size_t>(size)));
    }
    isInside = false;
  }
  const bool isFailing =
    (number == failing || (failingFrom > 0 && number >= failingFrom)) && !isFromCellArray(caller);
  errno = isFailing ? ENOMEM : errno;
  return isFailing;
}

long numberIn(const char* variable)
{
  const char* text = std::getenv(variable);
  return text ? std::atol(text) : 0;
}

int countingMain(int argc, char** argv, char** environment)
{
  failing = numberIn("FAULT_ALLOCATION");
  failingFrom = numberIn("FAULT_ALLOCATIONS_FROM");
  if (const char* file = std::getenv("FAULT_SITES"))
  {
    sites = open(file, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    void* callers[1];
    backtrace(callers, 1); // loads what it needs, which allocates
  }
  isCounting = true;
  return realMain(argc, argv, environment);
}

} // namespace

extern "C"
{

  void* malloc(std::size_t size)
  {
    return fails(__builtin_return_address(0)) ? nullptr : __libc_malloc(size);
  }

  void* calloc(std::size_t count, std::size_t size)
  {
    return fails(__builtin_return_address(0)) ? nullptr : __libc_calloc(count, size);
  }

  void* realloc(void* block, std::size_t size)
  {
    return fails(__builtin_return_address(0)) ? nullptr : __libc_realloc(block, size);
  }

  void* memalign(std::size_t alignment, std::size_t size)
  {
    return fails(__builtin_return_address(0)) ? nullptr : __libc_memalign(alignment, size);
  }

  void* aligned_alloc(std::size_t alignment, std::size_t size)
  {
    return memalign(alignment, size);
  }

  int posix_memalign(void** block, std::size_t alignment, std::size_t size)
  {
    void* const found = memalign(alignment, size);
    *block = found ? found : *block;
    return found ? 0 : ENOMEM;
  }

  void* dlopen(const char* file, int mode)
  {
    using Open = void* (*)(const char*, int);
    const auto open = reinterpret_cast<Open>(dlsym(RTLD_NEXT, "dlopen"));
    const bool wasInside = std::exchange(isInside, true);
    void* const library = open(file, mode);
    isInside = wasInside;
    return library;
  }

  /// The C library's own start of programs; main() is called in between.
  // NOLINTNEXTLINE(bugprone-reserved-identifier, readability-identifier-naming)
  int __libc_start_main(Main main, int argc, char** argv, void (*init)(), void (*fini)(),
    void (*linkerFini)(), void* stackEnd)
  {
    using Start = int (*)(Main, int, char**, void (*)(), void (*)(), void (*)(), void*);
    realMain = main;
    const auto start = reinterpret_cast<Start>(dlsym(RTLD_NEXT, "__libc_start_main"));
    return start(countingMain, argc, argv, init, fini, linkerFini, stackEnd);
  }

} // extern "C"
