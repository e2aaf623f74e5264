// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/SourceAdvice.h"

#include "field/InsideOut.h"
#include "report/InsideOutAdvice.h"

namespace winding
{

std::optional<Message> openSideAdvice(const FieldInfo& info, const OpenSideUse& use)
{
  const Openings& openings = info.openings;
  const bool isUnclear = use.threshold > 0 && !(openings.areOfSheet() && use.takesTouchedVoxels);
  if (!openings.areWide() || info.contradictingEdges > 0 || !(openings.lookInward || isUnclear))
  {
    return std::nullopt;
  }
  Message advice = openSideAdvice(openings);
  if (!openings.lookInward && use.mayCloseBorder)
  {
    // All behind the surface is inside then, up to the border.
    advice.remedies.back().settings.emplace_back(Parameter::closeBorder, 1);
  }
  return advice;
}

Message emptySourceAdvice(bool isWelded)
{
  std::vector<Remedy> remedies = {{"give a surface or points", {}}};
  if (isWelded)
  {
    remedies.push_back({"weld less", {Parameter::weldTolerance}});
  }
  return Message("the source is empty, so its field is 0", remedies);
}

Facing facingOf(const Field& field, const SideCounts& sides, InsideRule rule, double threshold,
  Executor& executor)
{
  Facing facing;
  if (rule != InsideRule::signedThreshold || field.info().hasNoSides || field.info().added != 0)
  {
    return facing;
  }
  const Inwardness inwardness = inwardnessOf(field, sides, executor);
  facing.looksInward = inwardness == Inwardness::solids;
  if (facing.looksInward)
  {
    facing.isInsideOut = sides.negative > sides.inside;
    facing.warning =
      insideOutAdvice(field.info().isSurface ? "faces" : "normals", sides, threshold);
  }
  else if (inwardness == Inwardness::sheets && !field.info().openings.areWide())
  {
    facing.warning = openSheetsAdvice();
  }
  return facing;
}

} // namespace winding
