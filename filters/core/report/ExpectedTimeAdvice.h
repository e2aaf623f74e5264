// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Message.h"
#include "field/Field.h"

#include <cstddef>
#include <optional>

namespace winding
{

/// Work on samples of a field.
struct ExpectedWork
{
  double seconds = 0; ///< that it is expected to take
  double limit = 0;   ///< the most that it may take; 0 for any
  std::size_t samples = 0;
};

/// Returns a message about `work` that takes more than a minute: how long it takes, and what would
/// be faster. Throws it as a Refusal beyond the limit of `work`.
std::optional<Message> expectedTimeAdvice(const FieldInfo& info, const ExpectedWork& work);

} // namespace winding
