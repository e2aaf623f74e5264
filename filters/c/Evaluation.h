// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Border.h"
#include "field/Field.h"
#include "source/Grid.h"
#include "winding.h"

#include <cstddef>
#include <functional>

namespace winding::c
{

/// Returns an extent of a grid, null for all of it. Throws Misuse where it lies elsewhere.
Extent extentOf(const Grid& grid, const int32_t* extent);

/// Does `work`, which evaluates samples of a field. Throws Refusal in the first seconds of work
/// that is expected to take longer than the caller wants.
void evaluateInTime(
  const Field& field, std::size_t samples, Call& call, const std::function<void()>& work);

} // namespace winding::c
