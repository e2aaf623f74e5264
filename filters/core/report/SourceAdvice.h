// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/InsideRule.h"
#include "base/Message.h"
#include "base/SideCounts.h"
#include "field/Field.h"

#include <optional>

namespace winding
{

/// The use of a source, by which it matters whether it is open on a whole side.
struct OpenSideUse
{
  double threshold = 0.5;
  bool takesTouchedVoxels = false; ///< whether voxels that the source touches are inside
  bool mayCloseBorder = false;     ///< whether the result ends at the grid's border, open
};

/// Returns what to do about a source that is open on a whole side, where it matters.
std::optional<Message> openSideAdvice(const FieldInfo& info, const OpenSideUse& use);

/// Returns what to do about a source without faces or points, which welding may have taken away.
Message emptySourceAdvice(bool isWelded);

/// The way in which a source faces, by the winding numbers of samples.
struct Facing
{
  bool looksInward = false; ///< as a whole or in part
  bool isInsideOut = false; ///< as a whole
  std::optional<Message> warning;
};

/// Finds out whether a source looks inward, or is of open sheets. Nothing is found with rules other
/// than InsideRule::signedThreshold, and for sources without sides. Throws Interrupted.
Facing facingOf(const Field& field, const SideCounts& sides, InsideRule rule, double threshold,
  Executor& executor);

} // namespace winding
