// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Digits.h"
#include "base/InsideRule.h"
#include "base/Message.h"
#include "base/SideCounts.h"

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
      hasFaces ? std::vector<Setting>{{Parameter::orientFaces, 1}} : std::vector<Setting>{}}};
}

/// Returns the warning that `what` are open sheets. `ways` say which side is inside.
inline Message openSheetsAdvice(const std::string& what, const std::vector<Setting>& ways)
{
  return {what + " are open sheets, which bound nothing",
    {ways.empty() ? Remedy{"close them", {}} : Remedy{"name the side that is inside", ways}},
    "w is about 0.5 behind them and -0.5 before them"};
}

/// Returns the warning that a source is inside out, as a whole or in part. `what` is "faces",
/// "normals", or "faces or normals" where either may be the cause.
inline Message insideOutAdvice(const std::string& what, const SideCounts& sides, double threshold)
{
  const auto share = [&sides](std::size_t count)
  {
    return percentOf(static_cast<double>(count) / static_cast<double>(sides.samples));
  };
  const std::string limit = inDigits(threshold, 3);
  const std::string shares = "w is -" + limit + " or less at " + share(sides.negative) +
                             " of the samples, and " + limit + " or more at " + share(sides.inside);
  return {what + " look inward", waysOutOfInward(what), shares};
}

} // namespace winding
