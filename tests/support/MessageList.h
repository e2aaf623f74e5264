// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fstream>
#include <map>
#include <string>

/// Returns the lines of tests/messages/words.txt for a front end ("C++", "ParaView", "program" or
/// "Python"), by what they are about.
inline std::map<std::string, std::string> messagesOf(const std::string& frontEnd)
{
  std::map<std::string, std::string> lines;
  std::ifstream file(WINDING_MESSAGES "/words.txt");
  std::string line, subject;
  while (std::getline(file, line))
  {
    if (line.empty() || line[0] == '#')
    {
      continue;
    }
    if (line[0] != ' ')
    {
      subject = line;
    }
    else if (line.rfind("  " + frontEnd + ": ", 0) == 0)
    {
      lines[subject] = line.substr(frontEnd.size() + 4);
    }
  }
  return lines;
}
