#pragma once

#include <string>

/**
 * @file
 * SIGINT, SIGTERM and SIGHUP end the program; a SIGHUP that the caller ignores, as nohup does, stays
 * ignored. The first signal asks: running filters are told to abort (Progress.h), and the program
 * leaves where it next looks. If that takes more than a second, or at a second signal, the program
 * leaves from the signal handler. Either way no half-written file stays.
 */
namespace interrupt
{

/// Handles signals in this way from now on.
void install();

/// Whether a signal has come.
bool requested();

/// Throws Failure if a signal has come.
void check();

/// Names a file that removeTemporaryFiles() removes until dropTemporaryFile() is told its name. Of
/// more than eight at a time, the ones that come late are not taken.
void addTemporaryFile(const std::string& path);
void dropTemporaryFile(const std::string& path);

/// Removes the files that have been named, for whoever leaves without unwinding. Signal handlers may
/// call it.
void removeTemporaryFiles();

} // namespace interrupt
