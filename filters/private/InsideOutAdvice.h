#pragma once

#include <string>

namespace winding
{

/// The warning where nothing is inside because a source is inside out; what: its faces or normals.
/// It names the remedy first, by the names that filters, ParaView and the program have for it.
inline std::string insideOutAdvice(const std::string& what)
{
  const std::string turning =
    what == "faces" ? "turn the faces (Fix Orientation, --fix-orientation)" : "turn the " + what;
  return turning + ", or use the inside rule absolute (--rule absolute): the " + what +
         " look inward, so w is negative where it should be positive, and nothing is inside";
}

} // namespace winding
