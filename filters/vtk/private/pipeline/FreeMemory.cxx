#include "private/pipeline/FreeMemory.h"

#include "private/pipeline/HostShare.h"

#include <vtksys/SystemInformation.hxx>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace winding
{

namespace
{

std::string inGiB(double bytes)
{
  char text[64];
  std::snprintf(text, sizeof text, "%.3g GiB", bytes / (1024.0 * 1024.0 * 1024.0));
  return text;
}

double freeBytesOf(const HostMemory& memory)
{
  return std::max(0.0, memory.total - memory.used) / ranksOnHost();
}

} // namespace

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
      what + " needs " + inGiB(bytes) + ", and " + inGiB(freeBytesOf(memory())) + " is free"));
  }
}

} // namespace winding
