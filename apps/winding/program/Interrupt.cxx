#include "program/Interrupt.h"

#include "program/Failure.h"

#include <csignal>
#include <cstring>

#include <unistd.h>

namespace interrupt
{

namespace
{

volatile std::sig_atomic_t signalled = 0;

// The handler reads an array because it may touch neither the heap nor a string that is being
// changed.
char temporaryFile[4096] = "";
volatile std::sig_atomic_t temporaryFileSet = 0;

void leave(int)
{
  if (temporaryFileSet)
  {
    unlink(temporaryFile);
  }
  const char message[] = "winding: interrupted\n";
  const ssize_t ignored = write(STDERR_FILENO, message, sizeof message - 1);
  static_cast<void>(ignored);
  _exit(INTERRUPTED);
}

void ask(int number)
{
  if (signalled)
  {
    leave(number);
  }
  signalled = 1;
  alarm(1);
}

} // namespace

void install()
{
  std::signal(SIGALRM, leave);
  struct sigaction action = {};
  action.sa_handler = ask;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGHUP, &action, nullptr);
}

bool requested()
{
  return signalled != 0;
}

void check()
{
  if (requested())
  {
    throw Failure(INTERRUPTED, "interrupted");
  }
}

void setTemporaryFile(const std::string& path)
{
  temporaryFileSet = 0;
  if (!path.empty() && path.size() < sizeof temporaryFile)
  {
    std::memcpy(temporaryFile, path.c_str(), path.size() + 1);
    temporaryFileSet = 1;
  }
}

} // namespace interrupt
