#pragma once

#include <stdexcept>
#include <string>

/// What the program returns to its caller.
enum ExitStatus
{
  DONE = 0,
  USAGE = 1,        ///< the command line makes no sense
  REFUSED = 2,      ///< a file cannot be read, worked with or written
  NO_MEMORY = 3,    ///< the result does not fit into memory
  INTERRUPTED = 130 ///< as shells report an end by SIGINT
};

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

  /// About a file.
  Failure(ExitStatus exitStatus, const std::string& file, const std::string& message)
    : Failure(exitStatus, file + ": " + message)
  {
  }

  ExitStatus status;
};
