// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/Interrupt.h"

#include "program/Failure.h"

#include <array>
#include <atomic>
#include <csignal>
#include <list>

#include <sys/time.h>
#include <unistd.h>

namespace interrupt
{

namespace
{

volatile std::sig_atomic_t signalled = 0;
volatile std::sig_atomic_t isSilent = 0;
volatile std::sig_atomic_t isOneOfSeveral = 0;

// The handler may run on any thread and at any moment, so that what it reads changes in one step: a
// pointer to a name.
std::array<std::atomic<const char*>, 8> temporaryFiles = {};
static_assert(std::atomic<const char*>::is_always_lock_free);

void leave(int)
{
  removeTemporaryFiles();
  if (!isSilent)
  {
    const char message[] = "winding: interrupted\n";
    const ssize_t ignored = write(STDERR_FILENO, message, sizeof message - 1);
    static_cast<void>(ignored);
  }
  removeTemporaryFiles(); // another thread may just have opened, and made, one of them again
  _exit(EXIT_INTERRUPTED);
}

void ask(int number)
{
  if (signalled)
  {
    leave(number);
  }
  signalled = 1;
  if (isOneOfSeveral)
  {
    const struct itimerval halfSecond = {{0, 0}, {0, 500000}};
    setitimer(ITIMER_REAL, &halfSecond, nullptr);
    return;
  }
  alarm(1);
}

bool wasHangupIgnored = false;

/// Notes whether the caller has hangups ignored. Sanitizers are not ready when it runs.
__attribute__((no_sanitize("address", "thread", "undefined"))) void noteHangup()
{
  struct sigaction before = {};
  sigaction(SIGHUP, nullptr, &before);
  wasHangupIgnored = before.sa_handler == SIG_IGN;
}

// UCX, a library of Open MPI 5, handles hangups as soon as it is loaded, even under nohup. What
// this section lists runs before the libraries' own code.
__attribute__((section(".preinit_array"), used)) void (*const noteHangupFirst)() = noteHangup;

} // namespace

void install()
{
  std::signal(SIGALRM, leave);
  struct sigaction action = {};
  action.sa_handler = ask;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  if (wasHangupIgnored)
  {
    std::signal(SIGHUP, SIG_IGN);
  }
  else
  {
    sigaction(SIGHUP, &action, nullptr);
  }
}

void joinRanks(bool isFirst)
{
  isSilent = !isFirst;
  isOneOfSeveral = 1;
}

void ignore()
{
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGALRM})
  {
    std::signal(number, SIG_IGN);
  }
}

bool requested()
{
  return signalled != 0;
}

void check()
{
  if (requested())
  {
    throw Failure(EXIT_INTERRUPTED, "interrupted");
  }
}

const char* keepName(const std::string& path)
{
  static std::list<std::string> names;
  return names.emplace_back(path).c_str();
}

void addTemporaryFile(const char* keptName)
{
  for (std::atomic<const char*>& file : temporaryFiles)
  {
    if (!file)
    {
      file = keptName;
      return;
    }
  }
}

void dropTemporaryFile(const char* keptName)
{
  for (std::atomic<const char*>& file : temporaryFiles)
  {
    if (file == keptName)
    {
      file = nullptr;
    }
  }
}

void forgetTemporaryFiles()
{
  for (std::atomic<const char*>& file : temporaryFiles)
  {
    file = nullptr;
  }
}

void removeTemporaryFiles()
{
  for (const std::atomic<const char*>& file : temporaryFiles)
  {
    if (const char* name = file)
    {
      unlink(name);
    }
  }
}

} // namespace interrupt
