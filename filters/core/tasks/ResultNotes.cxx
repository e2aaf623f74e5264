// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/ResultNotes.h"

#include "diagnosis/GridAdvice.h"
#include "report/Hollow.h"

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

void warnOfGrid(const Field& field, const Grid& grid, const ResultOnGrid& result,
  const Facing& facing, const InsideTest& isInside, Run& run)
{
  const Diagnosis& diagnosis = field.diagnosis();
  if (field.info().primitives == 0 || result.withoutAdvice || diagnosis.hasNoSides(run.executor))
  {
    return;
  }
  GridResult found;
  found.isEmpty = result.isEmpty && !facing.isInsideOut;
  found.mayTouch = result.mayTouchVoxels;
  found.isSheet = field.info().openings.areOfSheet();
  found.hasHighThreshold = isInside.hasHighThreshold();
  if (!facing.looksInward && !result.takesTouchedVoxels)
  {
    found.parts = diagnosis.thinParts(grid, result.isInside, isInside, run.executor);
  }
  if (found.parts)
  {
    found.parts->unboundShare = facing.warning ? 0 : found.parts->unboundShare;
    // Models of several parts enclose places between these.
    constexpr std::size_t mostPieces = 2;
    found.parts->mayBeTwoWalls = found.parts->areMany() && diagnosis.pieces() <= mostPieces &&
                                 diagnosis.hasEnclosedPoints(run.executor) &&
                                 thicknessOfWalls(field, isInside, run.executor) > 0;
  }
  // Volumes of several solids in one place add up, and a grid may cut a part off.
  const bool hasVolume = result.volume > 0 && result.sides.several + result.sides.negative == 0 &&
                         hasWhole(grid, field.info().bounds);
  if (found.parts && hasVolume && diagnosis.volume(run.executor) > 0)
  {
    found.parts->sourceVolume = diagnosis.volume(run.executor);
    found.parts->volumeRatio = result.volume / found.parts->sourceVolume;
    if (result.pieces > 0 && (found.parts->isVolumeOff() || !found.parts->voxels.empty()))
    {
      found.parts->sourcePieces = diagnosis.pieces();
      found.parts->pieces = found.parts->sourcePieces > 0 ? result.pieces : 0;
    }
  }
  if (const auto advice = gridAdvice(grid, field.info().bounds, found))
  {
    run.warn(*advice);
  }
  else if (result.crumbs > 0 && !facing.warning && !facing.isOfSheets &&
           !diagnosis.faultToTurn(run.executor))
  {
    constexpr double leastMiddle = 0.05, mostMiddle = 0.4;
    const double middle =
      2 * result.crumbs > result.pieces ? diagnosis.middleAtFaces(run.executor) : 0.5;
    run.warn(middle > leastMiddle && middle < mostMiddle
               ? sparseFacesAdvice(middle)
               : crumbsNote(result.crumbs, result.pieces, diagnosis.pieces()));
  }
}

Facing warnOfResult(const Field& field, const Grid& grid, const ResultOnGrid& result,
  const InsideTest& isInside, Run& run)
{
  const Facing facing = warnOfSides(field, result.sides, isInside, run);
  warnOfGrid(field, grid, result, facing, isInside, run);
  return facing;
}

} // namespace winding
