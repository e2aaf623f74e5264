#include "private/FreeMemory.h"

#include <vtksys/SystemInformation.hxx>

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

void refuseBeyondFreeMemory(double bytes, const std::string& what, const std::string& advice)
{
  constexpr double smallest = 64.0 * 1024 * 1024; // not worth asking the system for
  if (bytes < smallest)
  {
    return;
  }
  vtksys::SystemInformation system;
  system.RunMemoryCheck();
  const double freeBytes = 1024.0 * (static_cast<double>(system.GetHostMemoryTotal()) -
                                      static_cast<double>(system.GetHostMemoryUsed()));
  if (bytes > freeBytes)
  {
    throw OutOfMemory(what + " needs " + inGiB(bytes) + " of memory and " + inGiB(freeBytes) +
                      " is free; " + advice);
  }
}

} // namespace winding
