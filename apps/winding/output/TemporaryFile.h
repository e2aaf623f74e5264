// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

/**
 * A hidden file next to the one that it is to become: .<stem>.winding-<process>.part<suffix>. It is
 * locked as long as the run lives. One without a lock was left behind by a run that was killed, and
 * the next run that writes into the folder removes it, whatever its output.
 */
class TemporaryFile
{
public:
  /// Makes the file, empty. Throws std::system_error where the folder does not allow it.
  explicit TemporaryFile(const std::filesystem::path& target);
  /// Removes the file, unless it has become another.
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  void operator=(const TemporaryFile&) = delete;

  std::string name() const { return name_; }

  /// Gives the file the name of the target, and thereby replaces what had it. Throws
  /// std::system_error where that is not possible, and Failure if a signal has come.
  void become(const std::filesystem::path& target);

  /// Removes from a folder what runs that were killed have left behind.
  static void clear(const std::filesystem::path& folder);

private:
  const char* name_; ///< null when it has become another
  int lock_;         ///< the open file, which keeps the lock
};
