#pragma once

#include "base/InsideRule.h"
#include "base/Message.h"
#include "field/InsideOut.h"

#include <cstdio>
#include <string>
#include <vector>

namespace winding
{

/// Returns what to do about faces or normals that look inward.
inline std::vector<Remedy> waysOutOfInward(const std::string& what)
{
  // Polygons alone have faces that a filter turns.
  const bool hasFaces = what.rfind("faces", 0) == 0;
  return {{"", {{Parameter::insideRule, static_cast<int>(InsideRule::absoluteThreshold)}}},
    {"turn the " + what,
      hasFaces ? std::vector<Setting>{Parameter::turnedFaces} : std::vector<Setting>{}}};
}

/// Returns the warning that a source is inside out, as a whole or in part. `what` is "faces",
/// "normals", or "faces or normals" where either may be the cause.
inline Message insideOutAdvice(const std::string& what, const SideCounts& sides, double threshold)
{
  const auto percent = [&sides](std::size_t count)
  {
    return 100 * static_cast<double>(count) / static_cast<double>(sides.samples);
  };
  char shares[200];
  std::snprintf(shares, sizeof shares,
    "w is %.3g or less at %.2g %% of the samples, and %.3g or more at %.2g %%", -threshold,
    percent(sides.negative), threshold, percent(sides.inside));
  return {what + " look inward", waysOutOfInward(what), shares};
}

} // namespace winding
