// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/LabelAdvice.h"

#include "diagnosis/Diagnosis.h"
#include "diagnosis/GridAdvice.h"
#include "diagnosis/InsideOutAdvice.h"

namespace winding
{

void countThinParts(const Field& field, const IsSampleInside& hasLabel,
  const LabelSampling& sampling, const std::string& name, Executor& executor, LabelFacts& facts)
{
  const auto parts = field.diagnosis().thinParts(
    sampling.grid, hasLabel, sampling.rule, sampling.threshold, executor);
  if (parts && parts->areWorthTelling())
  {
    facts.lostInPart.add(name);
    if (parts->lostShare > facts.largestLoss.lostShare)
    {
      facts.largestLoss = *parts;
    }
  }
}

std::vector<Message> labelAdvice(
  const LabelFacts& facts, std::size_t count, const LabelSampling& sampling)
{
  const std::string causes = "faces or normals";
  std::vector<Message> advice;
  if (facts.insideOut.count() > 0)
  {
    advice.emplace_back("some solids look inward and have no label", waysOutOfInward(causes),
      facts.insideOut.outOf(count));
  }
  const auto ofGrid = gridAdvice(sampling.grid, facts.source.bounds, GridResult());
  if (ofGrid && facts.missed.count() == 0 && facts.source.primitives > 0)
  {
    advice.push_back(*ofGrid);
  }
  if (facts.missed.count() > 0)
  {
    advice.push_back({"the grid misses some solids",
      {{"choose a grid around them", {Parameter::samplingBounds}}}, facts.missed.outOf(count)});
  }
  if (facts.thin.count() > 0)
  {
    constexpr int any = 1; // as Coverage::any
    std::vector<Remedy> remedies = {
      smallerVoxels(), {"label what they touch", {{Parameter::coverage, any}}}};
    if (sampling.rule != InsideRule::odd && sampling.threshold > 0.5)
    {
      remedies.insert(remedies.begin(), lowerThreshold());
    }
    advice.emplace_back("some solids have no voxel inside", remedies, facts.thin.outOf(count));
  }
  if (facts.lostInPart.count() > 0)
  {
    advice.push_back(thinPartsAdvice(facts.largestLoss, sampling.grid, sampling.mayTouch));
    advice.back().facts += "; " + facts.lostInPart.outOf(count);
  }
  if (facts.hidden.count() > 0)
  {
    constexpr int smallest = 3; // as OverlapRule::smallestVolume
    advice.push_back({"others hide all voxels of some solids",
      {{"", {{Parameter::overlapRule, smallest}}}}, facts.hidden.outOf(count)});
  }
  if (facts.partlyInsideOut.count() > 0)
  {
    advice.emplace_back("parts of solids look inward and have no label", waysOutOfInward(causes),
      facts.partlyInsideOut.outOf(count));
  }
  return advice;
}

} // namespace winding
