// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace winding
{

/// The side of a solid's surface that its shell lies on.
enum class ShellSide
{
  inward,
  outward,
  centered ///< half of the thickness on either side
};

/// The signed distances, negative inside, between which a shape of a solid lies.
struct DistanceBand
{
  double low = -std::numeric_limits<double>::infinity();
  double high = 0;

  ///@{
  /// Whether a sample at a distance of at least 0 from the surface is below or above a limit. Its
  /// side alone counts for a limit of 0.
  bool isBelow(bool isInside, double distance) const
  {
    if (low < 0)
    {
      return std::isfinite(low) && isInside && distance >= -low;
    }
    return isInside || (low > 0 && distance <= low);
  }
  bool isAbove(bool isInside, double distance) const
  {
    return high > 0 ? !isInside && distance >= high : !isInside || (high < 0 && distance <= -high);
  }
  ///@}

  /// Returns the largest of the limits without its sign; an infinite one does not count.
  double farthest() const
  {
    return std::max(std::isfinite(low) ? std::abs(low) : 0, std::abs(high));
  }

  bool contains(bool isInside, double distance) const
  {
    return !this->isBelow(isInside, distance) && !this->isAbove(isInside, distance);
  }
};

/**
 * A shape that is made of a solid: its cavities are filled first, then its surface moves outward
 * by `offset`, inward if that is negative, and then a shell about the surface replaces it.
 *
 * Let s be the signed distance from the surface of the solid. The solid moved by r is s < r. Its
 * shell of thickness t is r − t < s < r inward, r < s < r + t outward, and r − t/2 < s < r + t/2
 * centered. Lengths are in the source's unit.
 */
struct SolidShape
{
  bool fillsCavities = false;
  double gapWidth = 0; ///< openings as wide as that do not let the outside into cavities
  double offset = 0;
  double shell = 0; ///< thickness of the shell; 0 for none
  ShellSide shellSide = ShellSide::inward;

  bool hasDistances() const { return offset != 0 || shell > 0; }
  bool isShell() const { return shell > 0 && offset == 0 && !fillsCavities; }
  bool isPlain() const { return !fillsCavities && !this->hasDistances(); }

  DistanceBand band() const
  {
    if (!(shell > 0))
    {
      return {-std::numeric_limits<double>::infinity(), offset};
    }
    switch (shellSide)
    {
    case ShellSide::inward:
      return {offset - shell, offset};
    case ShellSide::outward:
      return {offset, offset + shell};
    case ShellSide::centered:
      break;
    }
    return {offset - 0.5 * shell, offset + 0.5 * shell};
  }

  /// Returns by how much a grid should reach beyond the solid: as far as the shape does, and as the
  /// outside needs to get round it where gaps are closed.
  double reach() const { return std::max(this->band().high, fillsCavities ? gapWidth : 0.0); }
};

} // namespace winding
