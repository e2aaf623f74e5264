#include "report/ExpectedTimeAdvice.h"

#include "farfield/FarFieldAccuracy.h"

#include <cstdio>

namespace winding
{

namespace
{

/// Returns a time in the unit in which people would say it.
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

std::vector<Remedy> fasterThan(const FieldInfo& info, double tolerance)
{
  std::vector<Remedy> remedies;
  const bool sumsAll = info.method == Method::direct || info.method == Method::parity;
  if (sumsAll)
  {
    constexpr int automatic = static_cast<int>(Method::automatic);
    remedies.push_back({"", {{Parameter::method, automatic}}});
  }
  if (!sumsAll || tolerance < FarFieldAccuracy::finest)
  {
    remedies.push_back({"choose a larger tolerance", {Parameter::tolerance}});
  }
  remedies.push_back(info.isScattered ? Remedy{"choose fewer samples", {}} : largerVoxels());
  return remedies;
}

} // namespace

Message expectedTimeAdvice(
  const FieldInfo& info, double seconds, std::size_t samples, double tolerance)
{
  return {"this takes about " + inWords(seconds), fasterThan(info, tolerance),
    std::to_string(samples) + " samples of " + std::to_string(info.primitives) +
      (info.isSurface ? " triangles" : " points") + " by the method " + nameOf(info.method)};
}

Remedy moreTime(double limit)
{
  char allowed[64];
  std::snprintf(allowed, sizeof allowed, "allow more than %.4g s", limit);
  return {allowed, {Parameter::longestExpectedTime}};
}

} // namespace winding
