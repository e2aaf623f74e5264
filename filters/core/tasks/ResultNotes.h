// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/InsideRule.h"
#include "base/SideCounts.h"
#include "diagnosis/Diagnosis.h"
#include "field/Field.h"
#include "tasks/Task.h"

#include <cstddef>
#include <functional>

namespace winding
{

/// The facts that a result shows of a field on a whole grid.
struct ResultOnGrid
{
  SideCounts sides;
  bool isEmpty = false;            ///< whether nothing is inside
  bool takesTouchedVoxels = false; ///< whether voxels that the source touches are inside
  bool mayTouchVoxels = false;     ///< whether they could be
  bool withoutAdvice = false;      ///< whether nothing is said about the grid
  IsSampleInside isInside;         ///< null where nothing is known of single samples
  double volume = 0;               ///< of the surface, or 0 if it is not known
  std::size_t pieces = 0;          ///< or 0 if nothing is known of them
  std::size_t crumbs = 0;          ///< pieces of at most mostOfCrumb samples

  static constexpr std::size_t mostOfCrumb = 8;
};

/// Warns where a source is open on a whole side and that matters.
void warnOfOpenSide(const Field& field, const OpenSideUse& use, Run& run);

/// Warns where a source looks inward, by the sides of samples. Returns how it faces.
Facing warnOfSides(
  const Field& field, const SideCounts& sides, const InsideTest& isInside, Run& run);

/// Warns of a grid that does not show a source with this facing.
void warnOfGrid(const Field& field, const Grid& grid, const ResultOnGrid& result,
  const Facing& facing, const InsideTest& isInside, Run& run);

/// Warns as warnOfSides() and then warnOfGrid() do.
Facing warnOfResult(const Field& field, const Grid& grid, const ResultOnGrid& result,
  const InsideTest& isInside, Run& run);

} // namespace winding
