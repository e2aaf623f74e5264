// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

/// A folder for the parts of a file. It is removed again if it is new and empty.
class Folder
{
public:
  /// Makes the folder, unless it is there, for the parts of a file, which messages call by this
  /// word. Throws Failure, about the file, where that is not allowed.
  Folder(const std::string& folder, const std::string& file, const std::string& parts);
  ~Folder();
  Folder(const Folder&) = delete;
  void operator=(const Folder&) = delete;

  bool isNew() const { return isNew_; }

  /// Throws Failure, about the file, where one of the inputs lies in the folder.
  void refuseInputs(const std::vector<std::string>& inputs) const;

  /// Throws the Failure of a folder that holds files which are not parts of the file.
  [[noreturn]] void refuseOtherFiles() const;

private:
  std::string folder_;
  std::string file_;
  std::string parts_;
  bool isNew_;
};
