// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/FileHandle.h"

#include <cerrno>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace winding
{

FileHandle::FileHandle(const std::string& name)
{
  struct stat about = {};
  if (stat(name.c_str(), &about) != 0)
  {
    const bool isMissing = errno == ENOENT || errno == ENOTDIR;
    answer_ = isMissing ? FileAnswer::notFound : FileAnswer::cannotOpen;
    return;
  }
  if (!S_ISREG(about.st_mode))
  {
    // Opening a pipe would wait until somebody writes into it.
    answer_ = S_ISDIR(about.st_mode) ? FileAnswer::isFolder : FileAnswer::isSpecial;
    return;
  }
  const int descriptor = open(name.c_str(), O_RDONLY | O_CLOEXEC);
  handle_ = descriptor;
  if (descriptor < 0)
  {
    answer_ = errno == ENOENT ? FileAnswer::notFound : FileAnswer::cannotOpen;
    return;
  }
  answer_ = FileAnswer::opened;
  // The size belongs to the file that was opened, which may be another one by now.
  if (fstat(descriptor, &about) == 0 && about.st_size > 0)
  {
    size_ = static_cast<std::size_t>(about.st_size);
  }
}

FileHandle::~FileHandle()
{
  if (handle_ >= 0)
  {
    close(static_cast<int>(handle_));
  }
}

std::size_t FileHandle::read(std::size_t offset, char* bytes, std::size_t count) const
{
  ssize_t taken = -1;
  do
  {
    taken = pread(static_cast<int>(handle_), bytes, count, static_cast<off_t>(offset));
  } while (taken < 0 && errno == EINTR);
  return taken > 0 ? static_cast<std::size_t>(taken) : 0;
}

} // namespace winding
