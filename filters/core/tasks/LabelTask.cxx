// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/LabelTask.h"

#include "base/SideCounts.h"
#include "diagnosis/Diagnosis.h"
#include "diagnosis/GridAdvice.h"
#include "diagnosis/InsideOutAdvice.h"
#include "report/InputUnits.h"
#include "surface/OpenParts.h"
#include "tasks/MendedSource.h"

#include <algorithm>

namespace winding
{

namespace
{

SolidEvaluationOptions evaluationOptions(const LabelOptions& options, const FreeMemory& freeMemory)
{
  SolidEvaluationOptions result;
  result.voxels = options.voxels;
  result.withValues = options.overlapRule == OverlapRule::largestWindingNumber;
  result.freeMemory = freeMemory;
  return result;
}

} // namespace

LabelTask::LabelTask(const Grid& grid, const LabelArrays& arrays, const LabelOptions& options,
  LabelFacts& facts, Run& run)
  : grid_(grid)
  , arrays_(arrays)
  , options_(options)
  , isInside_(options.voxels.output.isInside)
  , facts_(facts)
  , merge_(
      arrays, options.overlapRule, isInside_.rule == InsideRule::absoluteThreshold, run.executor)
  , evaluation_(evaluationOptions(options, run.freeMemory))
{
}

double LabelTask::bytes(const LabelOptions& options, std::size_t samples)
{
  return SolidEvaluation::bytes(evaluationOptions(options, {}), samples);
}

void LabelTask::add(const Field& given, const FieldInfo& info, const LabeledSolid& solid, Run& run)
{
  facts_.add(info, solid.name, solid.isOpenPart);
  const bool bySize = options_.overlapRule == OverlapRule::smallestVolume;
  merge_.begin(solid.label, bySize ? sizeOf(given) : SolidSize(), solid.shares);
  const bool mayThicken = options_.voxels.coverage != Coverage::any && !solid.isOpenPart;
  Run noting = {
    run.executor, [&](const Message& note) { facts_.addMend(note, solid.name); }, run.freeMemory};
  MendedSource source(given, grid_, {options_.mendsSource, mayThicken, isInside_}, noting);
  source.decideByLayers();
  const Field& field = source.field();
  SideTally sides;
  evaluation_.run(field, source.plate(), grid_, arrays_.extent, merge_, &sides, run.executor);
  if (this->isWhole() && info.primitives > 0 && source.plate() == 0)
  {
    const double end = run.executor.share().second;
    run.executor.setShare(end, end);
    this->inspectResult(field, sides.counts(sampleCount(arrays_.extent)), solid, run);
  }
}

void LabelTask::inspectResult(
  const Field& field, const SideCounts& sides, const LabeledSolid& solid, Run& run)
{
  const Diagnosis& diagnosis = field.diagnosis();
  const bool hasVoxels = merge_.hasInside();
  if (hasVoxels)
  {
    shown_.push_back(solid);
  }
  if (diagnosis.facing(sides, isInside_, run.executor).looksInward)
  {
    (hasVoxels ? facts_.partlyInsideOut : facts_.insideOut).add(solid.name);
  }
  else if (hasVoxels)
  {
    const auto hasLabel = [this](int i, int j, int k)
    {
      return arrays_.labels[sampleNumber(arrays_.extent, i, j, k)] != 0;
    };
    const auto parts = diagnosis.thinParts(grid_, hasLabel, isInside_, run.executor);
    if (parts && parts->areWorthTelling())
    {
      facts_.lostInPart.add(solid.name);
      if (facts_.lostInPart.count() == 1 || parts->lostShare > facts_.largestLoss.lostShare)
      {
        facts_.largestLoss = *parts;
      }
    }
  }
  else if (!solid.isOpenPart && !diagnosis.hasNoSides(run.executor))
  {
    (missesSource(grid_, field.info().bounds) ? facts_.missed : facts_.thin).add(solid.name);
  }
}

void LabelTask::warn(bool haveOneUnit, Run& run) const
{
  const std::size_t count = facts_.expected;
  if (facts_.empty.count() == count)
  {
    run.warn({"there is no solid, so all labels are 0", {{"give a surface or points", {}}}});
  }
  else if (facts_.empty.count() > 0)
  {
    run.warn({"no voxel has the labels of empty blocks", {{"leave them out", {}}},
      facts_.empty.outOf(count)});
  }
  for (const auto& [note, solids] : facts_.mends)
  {
    Message ofAll = note;
    ofAll.facts += (ofAll.facts.empty() ? "" : "; ") + solids.outOf(count);
    run.warn(ofAll);
  }
  const auto units = unitAdvice(facts_.bounds);
  if (units && !haveOneUnit)
  {
    run.warn(*units);
  }
  if (facts_.openParts.count() > 0)
  {
    run.warn(openPartsAdvice("they bound nothing; " + facts_.openParts.outOf(count)));
  }
  if (facts_.open.count() > 0)
  {
    run.warn({"some solids have holes", {{"close them where labels are not right", {}}},
      facts_.open.outOf(count)});
  }
  if (this->isWhole())
  {
    this->warnOfLabels(run);
  }
}

/// Warns of solids without a label, as a whole or in part.
void LabelTask::warnOfLabels(Run& run) const
{
  const std::size_t count = facts_.expected;
  const std::string causes = "faces or normals";
  if (facts_.insideOut.count() > 0)
  {
    run.warn({"some solids look inward and have no label", waysOutOfInward(causes),
      facts_.insideOut.outOf(count)});
  }
  const auto ofGrid = gridAdvice(grid_, facts_.source.bounds, GridResult());
  if (ofGrid && facts_.missed.count() == 0 && facts_.source.primitives > 0)
  {
    run.warn(*ofGrid);
  }
  if (facts_.missed.count() > 0)
  {
    run.warn({"the grid misses some solids",
      {{"choose a grid around them", {Parameter::samplingBounds}}}, facts_.missed.outOf(count)});
  }
  if (facts_.thin.count() > 0)
  {
    std::vector<Remedy> remedies = {smallerVoxels(),
      {"label what they touch", {{Parameter::coverage, static_cast<int>(Coverage::any)}}}};
    if (isInside_.hasHighThreshold())
    {
      remedies.insert(remedies.begin(), lowerThreshold());
    }
    run.warn({"some solids have no voxel inside", remedies, facts_.thin.outOf(count)});
  }
  if (facts_.lostInPart.count() > 0)
  {
    const bool mayTouch = options_.voxels.coverage == Coverage::center;
    Message advice = thinPartsAdvice(facts_.largestLoss, grid_, mayTouch);
    advice.facts += "; " + facts_.lostInPart.outOf(count);
    run.warn(advice);
  }
  std::vector<char> isLabel(largestLabel + 1, 0);
  std::for_each(arrays_.labels, arrays_.labels + sampleCount(arrays_.extent),
    [&isLabel](unsigned short label) { isLabel[label] = 1; });
  NamedSolids hidden;
  for (const LabeledSolid& solid : shown_)
  {
    if (!isLabel[solid.label])
    {
      hidden.add(solid.name);
    }
  }
  if (hidden.count() > 0)
  {
    run.warn({"others hide all voxels of some solids",
      {{"", {{Parameter::overlapRule, static_cast<int>(OverlapRule::smallestVolume)}}}},
      hidden.outOf(count)});
  }
  if (facts_.partlyInsideOut.count() > 0)
  {
    run.warn({"parts of solids look inward and have no label", waysOutOfInward(causes),
      facts_.partlyInsideOut.outOf(count)});
  }
}

} // namespace winding
