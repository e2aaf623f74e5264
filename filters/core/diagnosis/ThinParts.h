// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Message.h"
#include "rays/SurfaceSamples.h"
#include "source/Grid.h"

#include <functional>
#include <vector>

namespace winding
{

/// How thick the walls of a surface are.
struct WallSamples
{
  std::vector<SurfaceSample> points;
  std::vector<double> thicknesses; ///< by point; infinite where no other side was met
  std::vector<double> shares;      ///< by point: probability that its other side was met

  /// Returns the indices of the walls whose other side was met, the thinnest first.
  std::vector<std::size_t> inOrder() const;
};

/// The part of a surface that a grid does not show, since what it encloses has no sample inside.
struct ThinParts
{
  double lostShare = 0;           ///< of the area, 0 to 1, that no sample near shows
  double thinShare = 0;           ///< of the area that bounds walls thinner than a voxel
  double thickness = 0;           ///< most of these parts are as thick, or 0 if it is not known
  bool hasLostPoints = false;     ///< whether no sample shows some of the points, thin or not
  std::size_t components = 0;     ///< connected sets of triangles; 0 where none is lost
  std::size_t lostComponents = 0; ///< that no sample is inside of

  /// Returns whether a twentieth of the surface or more is lost, or a twelfth is thinner than a
  /// voxel.
  bool areWorthTelling() const;

  /// Leaves a share of these parts. Their thicknesses are among `walls`, in ascending order.
  void keep(double share, const std::vector<double>& walls, const Grid& grid);
};

/// Returns whether the sample (i, j, k) of a grid is inside.
using IsSampleInside = std::function<bool(int i, int j, int k)>;

/// Estimates which part of a surface is lost on a grid: of the cell of samples round a point no
/// corner is inside, and the wall there is thinner than the cell's diagonal. Points in the grid's
/// outer half voxel do not count.
ThinParts thinPartsOf(const WallSamples& walls, const Grid& grid, const IsSampleInside& isInside);

/// Counts the connected sets of triangles of a closed surface that are lost: they are smaller than
/// two voxels along some axis, and no sample of their bounds and next to them is inside. Takes 25
/// ns per triangle, and looks at 65 536 samples at most: sets beyond do not count.
void countLostComponents(
  const Surface& surface, const Grid& grid, const IsSampleInside& isInside, ThinParts& parts);

/// Returns what to do about parts thinner than a voxel, or about components that are lost.
/// `mayTouch` says whether voxels that the source touches could count.
Message thinPartsAdvice(const ThinParts& parts, const Grid& grid, bool mayTouch);

} // namespace winding
