#pragma once

#include "vtkOutputWindow.h"

#include <mutex>
#include <set>
#include <string>

/**
 * Where VTK's errors and warnings go: without the decoration with source files and addresses, one
 * line each. Warnings are printed at once; the first error is kept for throwIfError(), since those
 * that follow it are consequences.
 */
class Messages : public vtkOutputWindow
{
public:
  static Messages* New();
  vtkTypeMacro(Messages, vtkOutputWindow);

  /// Makes a window VTK's own and returns it; it lives as long as the program.
  static Messages& install(bool quiet);

  /// The file that warnings are about from now on.
  void setSubject(const std::string& file);

  /// Throws the first error since the last call as a Failure about the file.
  void throwIfError(const std::string& file);

  /// Prints "winding: warning: ..." unless quiet or printed before.
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

/// One line on standard error, in place of a progress bar that may stand there.
void printLine(const std::string& line);

/// What to say where memory has run out.
std::string outOfMemoryAdvice();
