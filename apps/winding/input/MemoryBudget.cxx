#include "input/MemoryBudget.h"

#include <algorithm>
#include <fstream>

#include <unistd.h>

namespace
{

/// Threads, buffers and all else that does not depend on the file take less than so many bytes.
constexpr std::uintmax_t fixedBytes = std::uintmax_t(1) << 30;

/// A byte of a packed file holds less than so many bytes, unless they are constants.
constexpr std::uintmax_t bytesPerByte = 256;

/// The address space in use, in bytes; 0 where the system does not tell.
std::uintmax_t usedBytes()
{
  std::uintmax_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uintmax_t>(sysconf(_SC_PAGESIZE));
}

} // namespace

MemoryBudget::MemoryBudget(std::uintmax_t fileSize)
{
  getrlimit(RLIMIT_AS, &before_);
  const std::uintmax_t used = usedBytes();
  const std::uintmax_t budget = used + fixedBytes + bytesPerByte * fileSize;
  if (used > 0)
  {
    struct rlimit limit = before_;
    limit.rlim_cur = std::min<std::uintmax_t>(before_.rlim_cur, budget);
    setrlimit(RLIMIT_AS, &limit);
  }
}

MemoryBudget::~MemoryBudget()
{
  setrlimit(RLIMIT_AS, &before_);
}
