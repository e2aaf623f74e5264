#pragma once

#include <string>

/**
 * @file
 * SIGINT, SIGTERM and SIGHUP end the program. The first signal asks: running filters are told to
 * abort (Progress.h), and the program leaves where it next looks. If that takes more than a second,
 * or at a second signal, the program leaves from the signal handler. Either way no half-written
 * file stays.
 */
namespace interrupt
{

/// Handles signals in this way from now on.
void install();

/// Whether a signal has come.
bool requested();

/// Throws Failure if a signal has come.
void check();

/// Names the file to remove when leaving from the handler; an empty name is no file.
void setTemporaryFile(const std::string& path);

} // namespace interrupt
