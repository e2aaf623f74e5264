// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include <functional>

struct Options;

/// Returns whether the command line had an option, such as "--output".
using WasGiven = std::function<bool(const char* option)>;

/// Throws Failure(EXIT_USAGE) for a number of a command's options that is out of its range in
/// Options.def.
void checkRanges(const CLI::App& command);

/// Throws Failure(EXIT_USAGE) for options that make no sense together, or that filters do not have.
/// Options of bench are checked where they are used.
void checkOptions(const Options& options, const WasGiven& wasGiven);
