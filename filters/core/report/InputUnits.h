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
 * Returns a warning of inputs that seem to be in another unit than the others; none where all fit.
 *
 * An input is noticed if its coordinates times 1000, 25.4 or the inverse of these fit the others,
 * and do not as they are. It is compared with the box of all others that are not tiny themselves:
 * - As it is, it is more than 20 times as large or as small, and has no side in common with the
 *   box.
 * - Times the factor, it is at most 20 times as large or as small. Its box touches the other one,
 *   and two of its sides or more lie in sides of that. One side is enough for a flat input that
 *   lies within a side of the other box.
 *
 * Sides have a plane in common within a thousandth of the smaller size. Planes through the origin
 * do not count, since factors leave them where they are. A factor of 10 or 100 is never looked for:
 * a body in its far field, or a bolt in its machine, has that ratio by chance.
 *
 * Where inputs of either unit may be wrong, those are named that are compared with more others, or
 * else the fewer ones, or else the smaller ones. A uniform scale of all coordinates changes
 * nothing.
 */
std::optional<Message> unitAdvice(const std::vector<NamedBounds>& inputs);

} // namespace winding
