// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "base/Message.h"
#include "base/SolidShape.h"
#include "diagnosis/ThinParts.h"
#include "source/Grid.h"

#include <optional>

namespace winding
{

/// Facts about a result on a grid.
struct GridResult
{
  bool isEmpty = false;           ///< whether no sample is inside
  bool mayTouch = false;          ///< whether voxels could count that the source touches
  std::optional<ThinParts> parts; ///< that the grid does not show
  bool hasHighThreshold = false;  ///< whether w must be more than ½ to be inside
  bool isSheet = false;           ///< whether the source is nearly plane, and open
};

/**
 * Returns what to do about a grid that does not show a source with these bounds: where it misses
 * them, where the source has less than three voxels along an axis, where parts are lost between
 * samples, or where no sample is inside. An axis without any extent does not count: no grid would
 * help.
 */
std::optional<Message> gridAdvice(const Grid& grid, const Bounds& source, const GridResult& result);

/// The warning for pieces of a result that have a few voxels. Tips and noise leave some, and finer
/// grids may leave more; so these are proposed where `sourcePieces` are as many.
Message crumbsNote(std::size_t crumbs, std::size_t pieces, std::size_t sourcePieces);

/// The warning for faces so sparse that w is no more than `middle` at them, instead of ½.
Message sparseFacesAdvice(double middle);

/// Throws Refusal for a grid with one voxel along an axis: it has no edges for a surface to cross.
void refuseFlatGrid(const Grid& grid);

/// Returns what to do about a surface that is empty because all samples are inside.
Message allInsideAdvice();

/// The warning for an operation on solids that leaves nothing. `mayMiss` says whether it does where
/// they do not meet.
Message emptyResultAdvice(bool mayMiss);

/// The warning for a surface that is open where it reaches the border of the grid.
Message openResultAdvice();

/// Returns what to do about the shape of a solid that leaves nothing, that is all of the grid, or
/// that is too thin for it.
std::optional<Message> shapeAdvice(
  const Grid& grid, const SolidShape& shape, bool isEmpty, bool isAllInside);

/// Returns the remedy for sources that reach the threshold nowhere.
inline Remedy lowerThreshold()
{
  return {"choose a lower threshold", {Parameter::windingThreshold}};
}

/// Returns whether a grid has no voxel in common with the bounds of a source.
bool missesSource(const Grid& grid, const Bounds& source);

/// Returns whether the voxels of a grid cover the bounds of a source.
bool hasWhole(const Grid& grid, const Bounds& source);

} // namespace winding
