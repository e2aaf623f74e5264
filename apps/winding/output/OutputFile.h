// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output/TemporaryFile.h"

#include <filesystem>
#include <string>
#include <vector>

/**
 * A file that takes its name when it is complete. It is written under a name of its own in the same
 * folder (TemporaryFile.h); commit() renames it, and without commit() it is removed again. Where
 * the name is a link, it stays one, and the file that it leads to is replaced. A file that is
 * write-protected is not replaced.
 */
class OutputFile
{
public:
  /**
   * Makes the temporary file. Throws Failure, before any work, where the folder does not allow it,
   * where the file that has the name may not be replaced, or is one of `inputs`, by whatever
   * spelling or link.
   */
  OutputFile(const std::string& name, const std::vector<std::string>& inputs);

  const std::string& name() const { return name_; }

  /// The name of the file to write to until commit().
  std::string temporaryName() const { return temporary_.name(); }

  /// Throws the Failure of a writer that had to stop.
  [[noreturn]] void refuseWriting() const;

  /// Throws Failure where the disk is full, so that what was written may be incomplete.
  void checkIsWhole() const;

  /// Gives the file its name. Throws Failure as checkIsWhole() does, and where the file that has
  /// the name may no longer be replaced; that one stays then.
  void commit();

private:
  std::string name_;
  std::vector<std::string> inputs_;
  std::filesystem::path target_; ///< the name, or the file that it leads to
  TemporaryFile temporary_;
};
