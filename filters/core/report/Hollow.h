// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/InsideRule.h"
#include "base/Message.h"

#include <optional>

namespace winding
{

class Field;

/// A cavity that narrow openings lead to from outside.
struct Hollow
{
  double opening;  ///< width of the widest opening, about
  double gapWidth; ///< that closes all openings (SolidShape::gapWidth)

  /// Returns what closes them.
  Remedy remedy() const;
};

/// Returns the thickness that half of the walls of a solid have at most, by area; 0 where less than
/// half of the surface has a wall thinner than a tenth of the longest side of its bounds. Throws
/// Interrupted.
double thicknessOfWalls(const Field& field, const InsideTest& isInside, Executor& executor);

/**
 * Finds the largest cavity of a solid that openings lead to. They must be a third as wide as the
 * cavity at most, and the cavity must have a hundredth of the volume of the bounds. Nothing is
 * looked for where no place is enclosed (Diagnosis::hasEnclosedPoints()).
 *
 * Samples are the middles of about 112³ cubic voxels, with a margin, but not of more than 256
 * along the longest side, nor smaller than `smallestVoxel`. The outside and the cavity meet at the
 * sample with the largest distance d from the surface that any way from one to the other must pass.
 * Samples miss the middle of an opening by up to half of a voxel h: so its width is about
 * 2 d + h / 2. Openings narrower than h are not found, nor ones wider than a twelfth of the longest
 * side; cavities without any are none. Throws Interrupted.
 */
std::optional<Hollow> findHollow(
  const Field& field, const InsideTest& isInside, Executor& executor, double smallestVoxel = 0);

} // namespace winding
