#pragma once

#include <string>

namespace winding
{

/// The warning where nothing is inside because a source is inside out. It names the remedy first,
/// by the names that filters, ParaView and the program have for it. what: "faces", "normals", or
/// "faces or normals" where either may be the cause.
inline std::string insideOutAdvice(const std::string& what)
{
  const std::string faces = "faces";
  std::string turned = what;
  if (what.rfind(faces, 0) == 0)
  {
    turned.insert(faces.size(), " (filter Surface Report with Fix Orientation; winding check INPUT "
                                "--fix-orientation -o FIXED.vtp)");
  }
  return "turn the " + turned +
         ", or use the inside rule absolute (Inside Rule; --rule absolute): " + what +
         " look inward here, so w is negative where it should be positive, and nothing is inside";
}

} // namespace winding
