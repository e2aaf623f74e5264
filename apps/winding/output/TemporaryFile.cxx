// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/TemporaryFile.h"

#include "program/Interrupt.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <regex>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace
{

[[noreturn]] void throwError()
{
  throw std::system_error(errno, std::generic_category());
}

/// Locks an open file. False if another run has the lock; file systems without locks count as if
/// they gave it only where `isCertain` is false.
bool lock(int file, bool isCertain)
{
  return flock(file, LOCK_EX | LOCK_NB) == 0 || (!isCertain && errno != EWOULDBLOCK);
}

/// Removes a temporary file unless a run that lives has it.
void removeIfLeftBehind(const std::filesystem::path& path)
{
  const int file = open(path.c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (file < 0)
  {
    return;
  }
  if (lock(file, true))
  {
    unlink(path.c_str());
  }
  close(file);
}

/// Returns the beginning of a text in UTF-8, at most `bytes` bytes; no character is cut.
std::string beginning(const std::string& text, std::size_t bytes)
{
  std::size_t size = std::min(bytes, text.size());
  const auto isCut = [&text](std::size_t at)
  {
    return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80;
  };
  while (size > 0 && isCut(size))
  {
    --size;
  }
  return text.substr(0, size);
}

/// The name of the file for the n-th attempt to make one.
std::string nameFor(const std::filesystem::path& target, int n)
{
  // The suffix stands at the end: VTK's PLY writer would put one there otherwise.
  const std::string end = ".winding-" + std::to_string(getpid()) +
                          (n > 0 ? "-" + std::to_string(n) : "") + ".part" +
                          target.extension().string();
  constexpr std::size_t longest = 255; // of a name, in bytes
  return "." + beginning(target.stem().string(), longest - 1 - end.size()) + end;
}

/// Makes a file of that name and locks it. Returns -1, with errno, where that fails, and EEXIST
/// also stands for one that another run has taken for left behind before it was locked.
int makeLocked(const char* name)
{
  const int file = open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  struct stat status = {};
  if (file < 0 || (lock(file, false) && fstat(file, &status) == 0 && status.st_nlink > 0))
  {
    return file;
  }
  close(file);
  errno = EEXIST;
  return -1;
}

} // namespace

TemporaryFile::TemporaryFile(const std::filesystem::path& target)
{
  const std::filesystem::path folder = target.parent_path();
  clear(folder.empty() ? "." : folder);
  constexpr int attempts = 1000;
  for (int n = 0; n < attempts; ++n)
  {
    name_ = interrupt::keepName((folder / nameFor(target, n)).string());
    lock_ = makeLocked(name_);
    if (lock_ >= 0)
    {
      interrupt::addTemporaryFile(name_);
      return;
    }
    if (errno != EEXIST)
    {
      break;
    }
  }
  throwError();
}

void TemporaryFile::clear(const std::filesystem::path& folder)
{
  static const std::regex pattern(R"(\..*\.winding-[0-9]+(-[0-9]+)?\.part\.[A-Za-z]+)");
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
  {
    const std::string name = entry->path().filename().string();
    if (name[0] == '.' && std::regex_match(name, pattern))
    {
      removeIfLeftBehind(entry->path());
    }
  }
}

TemporaryFile::~TemporaryFile()
{
  if (name_)
  {
    unlink(name_);
    interrupt::dropTemporaryFile(name_);
  }
  close(lock_);
}

void TemporaryFile::become(const std::filesystem::path& target)
{
  interrupt::check(); // a run that was asked to end leaves the old file in place
  if (std::rename(name_, target.c_str()) != 0)
  {
    throwError();
  }
  interrupt::dropTemporaryFile(name_);
  name_ = nullptr;
}
