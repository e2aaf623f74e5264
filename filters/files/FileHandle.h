// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace winding
{

/// How the system answers a request to open a file.
enum class FileAnswer
{
  opened,
  notFound,
  isFolder,
  isSpecial, ///< a pipe, a device or a socket
  cannotOpen
};

/// A regular file that the system has opened for reading, by calls of POSIX (FileHandlePosix.cxx)
/// or of Windows (FileHandleWindows.cxx).
class FileHandle
{
public:
  /// Opens the file with the path `name`, which is in UTF-8 on Windows. It never waits for a pipe.
  explicit FileHandle(const std::string& name);
  ~FileHandle();
  FileHandle(const FileHandle&) = delete;
  void operator=(const FileHandle&) = delete;

  FileAnswer answer() const { return answer_; }

  /// The number of bytes when the file was opened; 0 where it was not.
  std::size_t size() const { return size_; }

  /// Copies at most `count` bytes from the place `offset` on to `bytes`, and returns how many; 0 at
  /// the end of the file and where it cannot be read. Any number of threads may read.
  std::size_t read(std::size_t offset, char* bytes, std::size_t count) const;

private:
  FileAnswer answer_ = FileAnswer::cannotOpen;
  std::size_t size_ = 0;
  std::intptr_t handle_ = -1; ///< POSIX: a descriptor; Windows: a HANDLE, -1 where it is invalid
};

} // namespace winding
