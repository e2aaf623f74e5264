// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Digits.h"
#include "base/Message.h"
#include "surface/Openings.h"

#include <algorithm>
#include <string>
#include <vector>

/**
 * @file
 * Notes on sources that were mended (FieldOptions::mendsSource), and ways to have it otherwise.
 */
namespace winding
{

/// Returns the remedy for a source that should not have been mended.
inline Remedy asItCame()
{
  return {"if that is wrong, leave it as it came", {{Parameter::mendSource, 0}}};
}

/// Returns whether a message proposes to turn faces, or to take them once.
inline bool proposesTurning(const Message& message)
{
  return std::any_of(message.remedies.begin(), message.remedies.end(),
    [](const Remedy& remedy)
    {
      return std::any_of(remedy.settings.begin(), remedy.settings.end(),
        [](const Setting& setting) { return setting.parameter == Parameter::orientFaces; });
    });
}

/// Returns the note on what was done because of a fault, as "faces were turned". Facts without a
/// number are about what would have come out otherwise.
inline Message mendedNote(const std::string& done, const Message& fault)
{
  const bool areOfSource = fault.facts.find_first_of("0123456789") != std::string::npos;
  return {done, {asItCame()}, areOfSource ? fault.fault + "; " + fault.facts : fault.fault};
}

/// Returns the note that points got normals.
inline Message estimatedNote()
{
  return {"normals were estimated, for the points had none",
    {{"give others", {Parameter::normalsArray}}, asItCame()}};
}

/// Returns the note that open sheets became a plate of this thickness, which users give or not.
inline Message plateNote(const Openings& openings, double thickness, bool isGiven)
{
  std::vector<Remedy> ways = {{"for a block close it by a base", {Parameter::flatBase}},
    {"name the side that is inside", {Parameter::sheetSide}}, asItCame()};
  if (openings.areOfSheet())
  {
    std::swap(ways[0], ways[1]);
    ways[0].words = "for a block name the side that is inside";
    ways[1].words = "close it by a base";
  }
  return {isGiven ? "open sheets became a plate, half on either side"
                  : "open sheets became a plate of three voxels",
    ways, joined("it is ", inDigits(thickness, 3), " thick")};
}

/// Returns the note that a surface was closed at the border of the grid.
inline Message closedBorderNote()
{
  return {"the surface reaches the border, and was closed there",
    {{"choose a larger grid", {Parameter::padding, Parameter::samplingBounds}}, asItCame()}};
}

} // namespace winding
