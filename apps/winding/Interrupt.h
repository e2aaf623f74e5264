#pragma once

#include <string>

/**
 * @file
 * SIGINT and SIGTERM. The first one asks: running filters are told to abort (Progress.h), and the
 * program leaves where it next looks. If that takes more than a second, or at a second signal, the
 * program leaves from the signal handler. Either way no half written file stays.
 */
namespace interrupt
{

/// From now on signals are handled as above.
void install();

/// Whether a signal has come.
bool requested();

/// Throws Failure if a signal has come.
void check();

/// The file to remove when leaving from the handler; empty: none.
void setTemporaryFile(const std::string& path);

} // namespace interrupt
