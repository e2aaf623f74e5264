#pragma once

#include "field/Field.h"

#include <string>

namespace winding
{

/// The line that says that a field takes long, and how long. It names what would be faster first,
/// by the names that filters, ParaView and the program have for it.
std::string expectedTimeAdvice(
  const FieldInfo& info, double seconds, std::size_t samples, double tolerance);

} // namespace winding
