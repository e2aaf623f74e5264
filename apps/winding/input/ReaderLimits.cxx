#include "input/ReaderLimits.h"

#include <algorithm>
#include <fstream>

#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

namespace
{

/// Buffers and all else that does not depend on the file take less than this number of bytes.
constexpr std::uintmax_t fixedBytes = std::uintmax_t(1) << 28;

/// A byte of a packed file holds less than this number of bytes, unless they are constants.
constexpr std::uintmax_t bytesPerByte = 256;

/// The slowest readers take a tenth of these seconds, most of them much less.
constexpr double fixedSeconds = 0.5;
constexpr double secondsPerByte = 1e-6;

/// The address space in use, in bytes; 0 where the system does not say.
std::uintmax_t usedBytes()
{
  std::uintmax_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uintmax_t>(sysconf(_SC_PAGESIZE));
}

void limitMemory(std::uintmax_t bytes)
{
  const std::uintmax_t used = usedBytes();
  struct rlimit limit = {};
  if (used > 0 && getrlimit(RLIMIT_AS, &limit) == 0)
  {
    limit.rlim_cur = std::min<std::uintmax_t>(limit.rlim_cur, used + bytes);
    setrlimit(RLIMIT_AS, &limit);
  }
}

void limitTime(double seconds)
{
  struct itimerval timer = {};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  timer.it_value.tv_usec =
    static_cast<suseconds_t>(1e6 * (seconds - static_cast<double>(timer.it_value.tv_sec)));
  setitimer(ITIMER_PROF, &timer, nullptr);
}

} // namespace

void limitToReading(std::uintmax_t fileSize)
{
  limitMemory(fixedBytes + bytesPerByte * fileSize);
  limitTime(fixedSeconds + secondsPerByte * static_cast<double>(fileSize));
}
