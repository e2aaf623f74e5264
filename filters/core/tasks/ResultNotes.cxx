// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/ResultNotes.h"

#include "diagnosis/GridAdvice.h"

namespace winding
{

void warnOfOpenSide(const Field& field, const OpenSideUse& use, Run& run)
{
  if (const auto advice = field.diagnosis().ofOpenSide(use))
  {
    run.warn(*advice);
  }
}

Facing warnOfSides(
  const Field& field, const SideCounts& sides, const InsideTest& isInside, Run& run)
{
  if (field.info().primitives == 0)
  {
    return {};
  }
  const Facing facing = field.diagnosis().facing(sides, isInside, run.executor);
  if (facing.warning)
  {
    run.warn(*facing.warning);
  }
  return facing;
}

Facing warnOfResult(const Field& field, const Grid& grid, const ResultOnGrid& result,
  const InsideTest& isInside, Run& run)
{
  const Facing facing = warnOfSides(field, result.sides, isInside, run);
  if (field.info().primitives == 0 || result.withoutAdvice ||
      field.diagnosis().hasNoSides(run.executor))
  {
    return facing;
  }
  GridResult found;
  found.isEmpty = result.isEmpty && !facing.isInsideOut;
  found.mayTouch = result.mayTouchVoxels;
  found.isSheet = field.info().openings.areOfSheet();
  found.hasHighThreshold = isInside.hasHighThreshold();
  if (!facing.looksInward && !result.takesTouchedVoxels)
  {
    found.parts = field.diagnosis().thinParts(grid, result.isInside, isInside, run.executor);
  }
  if (const auto advice = gridAdvice(grid, field.info().bounds, found))
  {
    run.warn(*advice);
  }
  return facing;
}

} // namespace winding
