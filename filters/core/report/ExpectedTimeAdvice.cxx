#include "report/ExpectedTimeAdvice.h"

#include "farfield/FarFieldAccuracy.h"

#include <cstdio>

namespace winding
{

namespace
{

/// A time in the unit in which people would say it.
std::string inWords(double seconds)
{
  constexpr double minute = 60, hour = 60 * minute, day = 24 * hour;
  struct Unit
  {
    double length;
    const char* name;
  };
  for (const Unit& unit : {Unit{day, "days"}, Unit{hour, "hours"}, Unit{minute, "minutes"}})
  {
    if (seconds >= 2 * unit.length)
    {
      char text[64];
      std::snprintf(text, sizeof text, "%.2g %s", seconds / unit.length, unit.name);
      return text;
    }
  }
  return std::to_string(static_cast<int>(seconds)) + " seconds";
}

/// The change of the settings that makes the field faster.
std::string fasterThan(const FieldInfo& info, double tolerance)
{
  const std::string fewer = info.isScattered ? "fewer samples" : "larger voxels";
  const bool sumsAll = info.method == Method::direct || info.method == Method::parity;
  if (sumsAll && tolerance < FarFieldAccuracy::finest)
  {
    return "choose a tolerance of 1e-6 or more (Tolerance; --tolerance) with the method automatic, "
           "or " +
           fewer;
  }
  return sumsAll ? "choose the method automatic (Method; --method), or " + fewer
                 : "choose " + fewer + " or a larger tolerance (Tolerance; --tolerance)";
}

} // namespace

std::string expectedTimeAdvice(
  const FieldInfo& info, double seconds, std::size_t samples, double tolerance)
{
  return fasterThan(info, tolerance) + ": method " + nameOf(info.method) + " takes about " +
         inWords(seconds) + " for " + std::to_string(samples) + " samples of " +
         std::to_string(info.primitives) + (info.isSurface ? " triangles" : " points");
}

} // namespace winding
