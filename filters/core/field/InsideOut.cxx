// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "field/InsideOut.h"

#include "cloud/CloudOrientation.h"
#include "surface/NearlyClosed.h"
#include "surface/Openings.h"

#include <algorithm>
#include <vector>

namespace winding
{

namespace
{

/// Returns whether a part of a surface is inside out that is closed or nearly closed, or that flat
/// lids would close. Others have no side that is inside, however they are turned.
bool hasInvertedPart(const Surface& surface, Executor& executor)
{
  const SurfaceEdges edges = edgesOf(surface, executor);
  Components components = componentsOf(surface, edges);
  std::vector<char> isCapped;
  const std::vector<JudgedComponent> parts =
    judgedComponents(surface, edges, components, isCapped, executor);
  if (std::any_of(parts.begin(), parts.end(),
        [](const JudgedComponent& part) { return part.lies.isInverted() && !part.isUnclear; }))
  {
    return true;
  }
  for (std::size_t i = 0; i < isCapped.size(); ++i)
  {
    components.isClosed[i] |= isCapped[i];
  }
  const std::vector<OpenComponent> open = openComponents(surface, components, executor);
  return std::any_of(open.begin(), open.end(),
    [](const OpenComponent& part) { return sideBehindLids(part.edges, part.surface) < 0; });
}

} // namespace

Inwardness inwardnessOf(const Field& field, const SideCounts& sides, Executor& executor)
{
  if (field.cloud())
  {
    return sides.negative > sides.inside && orientationOf(*field.cloud(), executor).isInward()
             ? Inwardness::solids
             : Inwardness::none;
  }
  const FieldInfo& info = field.info();
  if (sides.negative == 0)
  {
    return Inwardness::none;
  }
  if (100 * sides.negative < sides.negative + sides.inside)
  {
    // Small pockets of closed surfaces that cut themselves are common, small parts are meant.
    const bool isMeant = info.netBoundaryEdges == 0 && hasInvertedPart(*field.surface(), executor);
    return isMeant ? Inwardness::solids : Inwardness::none;
  }
  const bool areSheets =
    info.openings.areWide() || (info.netBoundaryEdges > 0 && info.contradictingEdges == 0 &&
                                 !hasInvertedPart(*field.surface(), executor));
  return areSheets ? Inwardness::sheets : Inwardness::solids;
}

} // namespace winding
