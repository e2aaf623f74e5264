// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/InsideRule.h"
#include "base/Message.h"
#include "field/Field.h"
#include "source/Grid.h"

#include <functional>
#include <optional>

namespace winding
{

/// The part of a surface that a grid does not show, since what it encloses has no sample inside.
struct ThinParts
{
  double share = 0;               ///< of the surface's area, 0 to 1
  double thickness = 0;           ///< nine tenths of that part are thicker, or 0 if it is not known
  std::size_t components = 0;     ///< connected sets of triangles; 0 where none is lost
  std::size_t lostComponents = 0; ///< that no sample is inside of

  /// Returns whether they are a twentieth of the surface or more.
  bool areWorthTelling() const;
};

/// Returns whether the sample (i, j, k) of a grid is inside.
using IsSampleInside = std::function<bool(int i, int j, int k)>;

/**
 * Estimates which part of a field's surface is lost on a grid: of the cell of samples round a point
 * no corner is inside. About 2000 points are taken (evenPoints()). Points in the grid's outer half
 * voxel do not count. Thicknesses are measured along the normals of some of the lost points, up to
 * the next triangle. Where the surface is open, points count as lost if w is inside by `rule`
 * halfway there.
 *
 * A connected set of triangles of a closed surface is lost if it is smaller than two voxels along
 * some axis, and no sample of its bounds and next to them is inside. They are counted where any is
 * lost, unless a twentieth of the surface is.
 *
 * Returns nothing for clouds. The estimate depends on the order of the triangles, and not on the
 * executor. It takes a millisecond, O(n) time for n triangles of a closed surface, and the time of
 * 64 rays through all triangles where a twentieth of the surface is lost. Throws Interrupted.
 */
std::optional<ThinParts> thinPartsOf(const Field& field, const Grid& grid,
  const IsSampleInside& isInside, InsideRule rule, double threshold, Executor& executor);

/// Finds the same where no samples are at hand: evaluates about 20 000 for the points, and up to a
/// million for small components. Ones that would need more count as not lost.
std::optional<ThinParts> thinPartsOf(
  const Field& field, const Grid& grid, InsideRule rule, double threshold, Executor& executor);

/// Returns what to do about parts thinner than a voxel, or about components that are lost.
/// `mayTouch` says whether voxels that the source touches could count.
Message thinPartsAdvice(const ThinParts& parts, const Grid& grid, bool mayTouch);

} // namespace winding
