// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause

// A fuzzer of the command line: each line of a case is an argument.

#include "options/CommandLine.h"
#include "program/Failure.h"

#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::vector<std::string> words = {"winding", ""};
  for (std::size_t i = 0; i < size; ++i)
  {
    const char letter = static_cast<char>(data[i]);
    if (letter == '\n')
    {
      words.emplace_back();
    }
    else if (letter != '\0')
    {
      words.back() += letter;
    }
  }
  std::vector<char*> arguments;
  for (std::string& word : words)
  {
    arguments.push_back(word.data());
  }
  try
  {
    parseCommandLine(static_cast<int>(arguments.size()), arguments.data());
  }
  catch (const Failure& failure)
  {
    if (failure.status != EXIT_USAGE)
    {
      __builtin_trap();
    }
  }
  return 0;
}
