// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/SideCounts.h"
#include "field/Field.h"

namespace winding
{

/// Counts about 100 000 of the `values` values, evenly spread over them, or all where there are
/// fewer.
template <class ValueAt>
SideCounts countSides(std::size_t values, double threshold, const ValueAt& valueAt)
{
  constexpr std::size_t most = 100'000;
  const std::size_t step = values / most + 1;
  SideCounts counts;
  for (std::size_t i = 0; i < values; i += step)
  {
    counts.add(valueAt(i), threshold);
  }
  return counts;
}

/// Reasons why w is negative where it should be positive.
enum class Inwardness
{
  none,
  solids, ///< faces or normals look inward
  sheets  ///< the surface is of open sheets, which have w of about ½ behind and −½ before them
};

/**
 * Returns whether faces or normals look inward. For surfaces that is where a hundredth or more of
 * the samples off the outside are negative, or fewer of a closed one, unless they are open on a
 * whole side (Openings.h). One of their parts must be inverted: a closed or nearly closed one
 * (ClosedComponents.h), or one that flat lids would close. Near single points of a cloud w
 * has any value; so for clouds most of these samples must be negative, and most normals must point
 * inward as well (CloudOrientation.h). Throws Interrupted.
 */
Inwardness inwardnessOf(const Field& field, const SideCounts& sides, Executor& executor);

} // namespace winding
