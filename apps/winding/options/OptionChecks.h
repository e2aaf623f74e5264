#pragma once

#include <functional>

struct Options;

/// Returns whether the command line had an option, such as "--output".
using WasGiven = std::function<bool(const char* option)>;

/// Throws Failure(USAGE) for options that make no sense, alone or together.
void checkOptions(const Options& options, const WasGiven& wasGiven);
