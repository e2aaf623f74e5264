// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/FreeMemory.h"

#include "pipeline/HostShare.h"

#include <vtksys/SystemInformation.hxx>

#include <algorithm>
#include <utility>

namespace winding
{

HostMemory hostMemory()
{
  vtksys::SystemInformation system;
  system.RunMemoryCheck();
  constexpr double unit = 1024;
  return {unit * static_cast<double>(system.GetHostMemoryTotal()),
    unit * static_cast<double>(system.GetHostMemoryUsed())};
}

double freeBytes(HostMemory (*memory)())
{
  const HostMemory found = memory();
  return std::max(0.0, found.total - found.used) / ranksOnHost();
}

void refuseBeyondFreeMemory(
  double bytes, const std::string& what, std::vector<Remedy> remedies, HostMemory (*memory)())
{
  refuseUnlessFree(
    bytes, [memory] { return freeBytes(memory); }, what, std::move(remedies));
}

} // namespace winding
