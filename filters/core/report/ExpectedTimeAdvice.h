#pragma once

#include "base/Message.h"
#include "field/Field.h"

namespace winding
{

/// Returns the message that a field of `samples` samples takes about `seconds`, and what would be
/// faster.
Message expectedTimeAdvice(
  const FieldInfo& info, double seconds, std::size_t samples, double tolerance);

} // namespace winding
