// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Message.h"
#include "field/Field.h"

namespace winding
{

/// Returns the message that a field of `samples` samples takes about `seconds`, and what would be
/// faster.
Message expectedTimeAdvice(
  const FieldInfo& info, double seconds, std::size_t samples, double tolerance);

/// Returns the remedy for work that is expected to take longer than a limit in seconds.
Remedy moreTime(double limit);

} // namespace winding
