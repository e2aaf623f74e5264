#include "private/FreeMemory.h"

#include <vtksys/SystemInformation.hxx>

#include <algorithm>
#include <cstdio>

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

} // namespace

HostMemory hostMemory()
{
  vtksys::SystemInformation system;
  system.RunMemoryCheck();
  constexpr double unit = 1024;
  return {unit * static_cast<double>(system.GetHostMemoryTotal()),
    unit * static_cast<double>(system.GetHostMemoryUsed())};
}

void refuseBeyondFreeMemory(
  double bytes, const std::string& what, const std::string& advice, HostMemory (*memory)())
{
  constexpr double smallest = 64.0 * 1024 * 1024; // not worth asking the system for
  if (bytes < smallest)
  {
    return;
  }
  const HostMemory found = memory();
  const double freeBytes = std::max(0.0, found.total - found.used);
  if (bytes > freeBytes)
  {
    throw OutOfMemory(what + " needs " + inGiB(bytes) + " of memory and " + inGiB(freeBytes) +
                      " is free; " + advice);
  }
}

} // namespace winding
