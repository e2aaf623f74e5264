// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

/// A folder of a test's own, removed with all that is in it at the end.
class TemporaryFolder
{
public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  void operator=(const TemporaryFolder&) = delete;

  std::string path(const std::string& name) const { return path_ + "/" + name; }

  /// Makes a file and returns its path.
  std::string write(const std::string& name, const std::string& contents) const;

  /// The names of the files in it, hidden ones too.
  std::vector<std::string> names() const;

private:
  std::string path_;
};

std::string contentsOf(const std::string& fileName);

/// The outcome of a run of the program.
struct Outcome
{
  int status = -1; ///< exit status; 128 and more if a signal ended the run
  std::string out;
  std::string err;

  nlohmann::json json() const { return nlohmann::json::parse(out); }

  /// Whether standard error is one line that begins like an error and has all of the parts.
  bool saysInOneLine(const std::vector<std::string>& parts) const;
};

/// Describes an outcome in the messages of failed expectations.
std::ostream& operator<<(std::ostream& stream, const Outcome& run);

/// Runs `winding` with the arguments; `before` is shell text in front of the command, such as
/// "ulimit -f 1;".
Outcome runProgram(const std::vector<std::string>& arguments, const std::string& before = "");

/// Starts `winding` in the background, without any output, and returns its process id.
int startProgram(const std::vector<std::string>& arguments);
