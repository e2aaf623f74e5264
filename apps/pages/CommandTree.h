// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

/**
 * @file
 * The commands and options of the program `winding`, as man pages and completions need them.
 */

/// An option, a flag or a positional argument.
struct OptionEntry
{
  std::vector<std::string> names; ///< as "-o" and "--output", or the one of a positional argument
  std::string values;             ///< what the help calls its values; empty for a flag
  std::string help;
  std::string group;
  bool isPositional = false;
  bool isRequired = false;
  int mostValues = 0;                ///< of one use of it; 0 for a flag
  std::vector<std::string> choices;  ///< the words that it takes; empty if it takes any
  bool isFile = false;               ///< whether its values are names of files
  std::vector<std::string> suffixes; ///< of these files, as "obj" and "nii.gz"; empty for any
  std::vector<std::string> excluded; ///< names of options that exclude it
  std::vector<std::string> needed;   ///< names of options that it needs
};

/// The program, with its commands, or one command.
struct CommandEntry
{
  std::string name;
  std::string help;
  std::vector<OptionEntry> options; ///< in the order of the help
  std::vector<CommandEntry> commands;
};

/// Returns the program as its own command line defines it.
CommandEntry describeProgram();

/// Returns the help of an option up to its first detail, for a line of a list.
std::string briefHelp(const std::string& help);
