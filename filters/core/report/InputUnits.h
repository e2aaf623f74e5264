// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "base/Message.h"

#include <optional>
#include <string>
#include <vector>

namespace winding
{

/// One of several inputs that are one source, or solids on one grid.
struct NamedBounds
{
  std::string name;
  Bounds bounds; ///< empty for an input without points
};

/**
 * Returns a warning of two inputs that seem to be in different units; none where all fit.
 *
 * One box has the sides of the other one times 25.4, 304.8 or 1000. They may differ by 1 % of the
 * longest side. Places do not matter, and neither does a uniform scale of all coordinates.
 * The smaller input is named, for nothing says which of the two is wrong.
 */
std::optional<Message> unitAdvice(const std::vector<NamedBounds>& inputs);

} // namespace winding
