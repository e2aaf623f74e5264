// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Message.h"
#include "rays/SampleLines.h"
#include "source/Grid.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace winding
{

/// The walls of a surface, at some of its points.
struct WallSamples
{
  std::vector<SurfaceSample> points;
  std::vector<SampleLine> lines; ///< by point
  std::vector<double> shares;    ///< by point: probability that its other side was met
  bool areWhole = true;          ///< whether all triangles could be met

  /// Adds a wall of others.
  void add(const WallSamples& from, std::size_t i);

  /// Leaves `count` walls, evenly chosen, or all where there are fewer.
  void leave(std::size_t count);

  /// Moves the surface outward by `distance`, or inward if that is negative, and its walls with it.
  /// Walls end where both sides meet.
  void move(double distance);
};

/// The part of a surface that a grid does not show, since what it encloses has no sample inside.
struct ThinParts
{
  double lostShare = 0;           ///< of the area, 0 to 1, that no sample near shows
  double thinShare = 0;           ///< of the area that bounds walls thinner than a voxel
  double thinVolume = 0;          ///< of these walls, if weights are areas
  std::vector<double> voxels;     ///< edges of cubes that thin walls are as thick as, ascending
  bool hasLostPoints = false;     ///< whether no sample shows some of the points, thin or not
  std::size_t components = 0;     ///< connected sets of triangles; 0 where none is lost
  std::size_t lostComponents = 0; ///< that no sample is inside of
  std::optional<Eigen::Vector3d> lostPlace; ///< on a part that is far from all samples inside
  double unboundShare = 0;      ///< of the area of an open surface that is far from samples inside
  double volumeRatio = 1;       ///< of the result's volume to the source's, 1 if it is not known
  double sourceVolume = 0;      ///< or 0 if it is not known
  std::size_t pieces = 0;       ///< of the result, or 0 if that is not known
  std::size_t sourcePieces = 0; ///< closed parts of the source
  bool mayBeTwoWalls = false;   ///< whether a hollow may lie between walls of the source

  /// Returns whether a twentieth of the surface or more is lost, or a twelfth is thinner than a
  /// voxel.
  bool areMany() const;

  bool isVolumeOff() const;

  /// Returns whether areMany(), or the volume is a fiftieth off, or there are new pieces that are
  /// more than tips and edges.
  bool areWorthTelling() const;

  /// Returns the edge of voxels that keep nearly all of these parts; 0 where nothing is thin.
  double largestVoxel() const;
};

/// Returns whether the sample (i, j, k) of a grid is inside.
using IsSampleInside = std::function<bool(int i, int j, int k)>;

/**
 * Estimates which part of a surface is thinner than a voxel on a grid, and which part of that is
 * lost: of the cell of samples round a point no corner is inside.
 *
 * A voxel is as thick as it is seen from along the wall's normal n: |n₁| h₁ + |n₂| h₂ + |n₃| h₃ for
 * edges h. Walls as thick as that separate their sides on a grid of any position. Points in the
 * grid's outer half voxel do not count.
 */
ThinParts thinPartsOf(const WallSamples& walls, const Grid& grid, const IsSampleInside& isInside);

/// Returns whether any sample of the cell round a point is inside; true beyond the grid.
bool isInsideNear(const Grid& grid, const Eigen::Vector3d& point, const IsSampleInside& isInside);

/// Returns whether any sample within three voxels of a point is inside; true beyond the grid.
bool isInsideWithinReach(
  const Grid& grid, const Eigen::Vector3d& point, const IsSampleInside& isInside);

/// Returns the first 16 of some triangles that have a corner out of reach of samples inside.
std::vector<std::int32_t> trianglesOutOfReach(const Surface& surface,
  const std::vector<std::int32_t>& triangles, const Grid& grid, const IsSampleInside& isInside);

/// Counts the connected sets of triangles of a closed surface that are lost: they are smaller than
/// two voxels along some axis, and no sample of their bounds and next to them is inside. Takes 25
/// ns per triangle, and looks at 65 536 samples at most: sets beyond do not count.
void countLostComponents(
  const Surface& surface, const Grid& grid, const IsSampleInside& isInside, ThinParts& parts);

/// Returns the number of connected sets of four triangles or more.
std::size_t piecesOf(const Surface& surface);

/// Returns the number of cubic voxels of this edge along the longest side of a grid, rounded up to
/// two digits; 0 where it is more than 4096.
int resolutionFor(double voxel, const Grid& grid);

/// Returns the fact that voxels of this edge would keep what is lost; empty where no resolution is.
std::string resolutionFact(double voxel, const Grid& grid);

/// Returns what to do about parts thinner than a voxel, or about components that are lost.
/// `mayTouch` says whether voxels that the source touches could count.
/// `what` says what the parts are.
Message thinPartsAdvice(
  const ThinParts& parts, const Grid& grid, bool mayTouch, const std::string& what = "parts");

} // namespace winding
