// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Border.h"
#include "base/SideCounts.h"
#include "diagnosis/ThinParts.h"
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
void evaluateInTime(const Field& field, double tolerance, std::size_t samples, Call& call,
  const std::function<void()>& work);

/// The facts that a result shows of a field on a whole grid.
struct ResultOnGrid
{
  SideCounts sides;
  bool isEmpty = false;            ///< whether nothing is inside
  bool takesTouchedVoxels = false; ///< whether voxels that the source touches are inside
  bool mayTouchVoxels = false;     ///< whether they could be
  bool mayCloseBorder = false;     ///< whether the result ends at the border, open
  bool withoutAdvice = false;      ///< whether nothing is said about the grid
  IsSampleInside isInside;
};

/// Warns where a source is open on a side or looks inward, and of a grid that does not show it.
void warnOfResult(const winding_field& handle, const Grid& grid, const ResultOnGrid& result,
  const winding_rule& rule, Call& call);

} // namespace winding::c
