// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options/Options.h"

#include <optional>

namespace CLI
{
class App;
}

/// Adds all commands and their options, which set `options`, to an empty `app`. Man pages and
/// completions are made of the same (apps/pages).
void addCommands(CLI::App& app, Options& options);

/**
 * Parses the command line. Prints help where that is asked for, and then returns nothing. Throws
 * Failure(EXIT_USAGE) for command lines that make no sense, whatever the input may be.
 */
std::optional<Options> parseCommandLine(int argc, char** argv);
