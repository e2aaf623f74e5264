#pragma once

#include "field/InsideOut.h"

#include <cstdio>
#include <string>

namespace winding
{

/// The warning where a source is inside out, as a whole or in part. It names the remedy first, by
/// the names that filters, ParaView and the program have for it. what: "faces", "normals", or
/// "faces or normals" where either may be the cause.
inline std::string insideOutAdvice(
  const std::string& what, const SideCounts& sides, double threshold)
{
  const std::string faces = "faces";
  std::string turned = what;
  if (what.rfind(faces, 0) == 0)
  {
    turned.insert(faces.size(), " (filter Surface Report with Fix Orientation; winding check INPUT "
                                "--fix-orientation -o FIXED.vtp)");
  }
  const auto percent = [&sides](std::size_t count)
  {
    return 100 * static_cast<double>(count) / static_cast<double>(sides.samples);
  };
  char shares[200];
  std::snprintf(shares, sizeof shares,
    "w is %.3g or less at %.2g %% of the samples, and %.3g or more at %.2g %%", -threshold,
    percent(sides.negative), threshold, percent(sides.inside));
  return "turn the " + turned +
         ", or use the inside rule absolute (Inside Rule; --rule absolute): " + what +
         " look inward here, for " + shares;
}

} // namespace winding
