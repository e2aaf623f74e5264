#pragma once

#include <CLI/CLI.hpp>

#include <functional>

struct Options;

/// Returns whether the command line had an option, such as "--output".
using WasGiven = std::function<bool(const char* option)>;

/// Throws Failure(USAGE) for a number of a command's options that is not in the range of the list of
/// options (Options.def).
void checkRanges(const CLI::App& command);

/// Throws Failure(USAGE) for options that make no sense together, or that filters do not have.
/// Those of bench are checked where they are used.
void checkOptions(const Options& options, const WasGiven& wasGiven);
