// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CommandTree.h"

#include <string>

/// Returns the man page winding(1). `date` is when it was made.
std::string manPageOfProgram(
  const CommandEntry& program, const std::string& date, const std::string& version);

/// Returns the man page of one command of the program.
std::string manPageOfCommand(
  const CommandEntry& command, const std::string& date, const std::string& version);

/// Return the completions of the program for a shell. They offer commands, options, the words that
/// options take, and files with the right suffixes.
std::string completionsForBash(const CommandEntry& program);
std::string completionsForZsh(const CommandEntry& program);
std::string completionsForFish(const CommandEntry& program);
