// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options/Options.h"

#include <optional>

/**
 * Parses the command line. Prints help where that is asked for, and then returns nothing. Throws
 * Failure(EXIT_USAGE) for command lines that make no sense, whatever the input may be.
 */
std::optional<Options> parseCommandLine(int argc, char** argv);
