// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/FreeMemory.h"

#include "base/Digits.h"
#include "pipeline/HostShare.h"

#include <vtksys/SystemInformation.hxx>

#include <algorithm>
#include <utility>

namespace winding
{

namespace
{

double freeBytesOf(const HostMemory& memory)
{
  return std::max(0.0, memory.total - memory.used) / ranksOnHost();
}

} // namespace

std::string memoryInWords(double bytes)
{
  constexpr double mebi = 1024.0 * 1024.0;
  const bool isLarge = bytes >= 1000 * mebi;
  return inDigits(bytes / (isLarge ? 1024 * mebi : mebi), 3) + (isLarge ? " GiB" : " MiB");
}

HostMemory hostMemory()
{
  vtksys::SystemInformation system;
  system.RunMemoryCheck();
  constexpr double unit = 1024;
  return {unit * static_cast<double>(system.GetHostMemoryTotal()),
    unit * static_cast<double>(system.GetHostMemoryUsed())};
}

bool isMemoryFree(double bytes, HostMemory (*memory)())
{
  constexpr double smallest = 64.0 * 1024 * 1024; // not worth asking the system for
  return bytes < smallest || bytes <= freeBytesOf(memory());
}

void refuseBeyondFreeMemory(
  double bytes, const std::string& what, std::vector<Remedy> remedies, HostMemory (*memory)())
{
  if (!isMemoryFree(bytes, memory))
  {
    throw OutOfMemory(Message("not enough memory", std::move(remedies),
      what + " needs " + memoryInWords(bytes) + ", and " + memoryInWords(freeBytesOf(memory())) +
        " is free"));
  }
}

} // namespace winding
