// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

/// The statuses that the program returns to its caller, written as EXIT_SUCCESS is.
// NOLINTBEGIN(readability-identifier-naming)
enum ExitStatus
{
  EXIT_DONE = 0,
  EXIT_USAGE = 1,        ///< the command line makes no sense
  EXIT_REFUSED = 2,      ///< a file cannot be read, worked with or written
  EXIT_NO_MEMORY = 3,    ///< the result does not fit into memory
  EXIT_INTERRUPTED = 130 ///< an end by SIGINT, as shells report it
};
// NOLINTEND(readability-identifier-naming)

/// Ends the program: what() is the line for standard error that says what is wrong, where, and what
/// to do about it.
class Failure : public std::runtime_error
{
public:
  Failure(ExitStatus exitStatus, const std::string& message)
    : std::runtime_error(message)
    , status(exitStatus)
  {
  }

  /// The message is about a file, whose name comes first.
  Failure(ExitStatus exitStatus, const std::string& file, const std::string& message)
    : Failure(exitStatus, file + ": " + message)
  {
  }

  ExitStatus status;
};

/// Throws Failure(EXIT_USAGE) with the message where a condition on the command line does not hold.
inline void requireUsage(bool condition, const std::string& message)
{
  if (!condition)
  {
    throw Failure(EXIT_USAGE, message);
  }
}
