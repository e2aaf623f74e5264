// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkOutputWindow.h"

#include <mutex>
#include <set>
#include <string>

/**
 * VTK's errors and warnings go here. Each becomes one line, without the source files and addresses
 * that VTK decorates it with. Warnings are printed at once; the first error is kept for
 * throwIfError(), since errors that follow it are its consequences.
 */
class Messages : public vtkOutputWindow
{
public:
  static Messages* New();
  vtkTypeMacro(Messages, vtkOutputWindow);

  /// Makes a window, gives it to VTK as its output window and returns it. It lives as long as the
  /// program. A quiet one prints no warnings.
  static Messages& install(bool quiet);

  /// Whether warnings and progress are not to be shown.
  bool isQuiet() const { return quiet_; }

  /// Names the file that warnings are about from now on.
  void setSubject(const std::string& file);

  /// Throws the first error since the last call as a Failure about the file.
  void throwIfError(const std::string& file);

  /// Prints "winding: warning: " and the text, unless quiet or printed before.
  void warn(const std::string& text);

  void DisplayText(const char* text) override;
  void DisplayErrorText(const char* text) override;
  void DisplayWarningText(const char* text) override;
  void DisplayGenericWarningText(const char* text) override;
  void DisplayDebugText(const char*) override {}

protected:
  Messages() = default;
  ~Messages() override = default;

private:
  bool quiet_ = false;
  std::string subject_;
  std::string error_;
  std::set<std::string> printed_;
  std::mutex mutex_;
};

/// Prints one line on standard error, in place of a progress bar that may stand there.
void printLine(const std::string& line);

/// The words for an end because memory has run out.
std::string outOfMemoryAdvice();
