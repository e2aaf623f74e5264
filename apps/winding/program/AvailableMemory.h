// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fstream>
#include <limits>
#include <string>

/// Returns the memory in bytes that the machine can give without taking it from other programs;
/// infinity where it does not say.
inline double availableMemory()
{
  std::ifstream file("/proc/meminfo");
  std::string name, rest;
  for (double kibibytes = 0; file >> name >> kibibytes && std::getline(file, rest);)
  {
    if (name == "MemAvailable:")
    {
      return 1024 * kibibytes;
    }
  }
  return std::numeric_limits<double>::infinity();
}
