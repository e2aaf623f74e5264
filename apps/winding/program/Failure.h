#pragma once

#include <stdexcept>
#include <string>

/// The statuses that the program returns to its caller, written as EXIT_SUCCESS is.
// NOLINTBEGIN(readability-identifier-naming)
enum ExitStatus
{
  DONE = 0,
  USAGE = 1,        ///< the command line makes no sense
  REFUSED = 2,      ///< a file cannot be read, worked with or written
  NO_MEMORY = 3,    ///< the result does not fit into memory
  INTERRUPTED = 130 ///< an end by SIGINT, as shells report it
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

/// Throws Failure(USAGE) with the message where a condition on the command line does not hold.
inline void requireUsage(bool condition, const std::string& message)
{
  if (!condition)
  {
    throw Failure(USAGE, message);
  }
}
