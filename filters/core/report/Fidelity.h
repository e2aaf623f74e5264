// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/SolidShape.h"
#include "distance/DistanceTree.h"
#include "field/Field.h"
#include "source/Surface.h"

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace winding
{

/// How near a surface that was made of a source is to it. Lengths are in the source's unit.
struct Fidelity
{
  std::size_t samples = 0; ///< points drawn from each of the two; 0 if one of them is empty
  ///@{
  /// Distances of points of the source from the surface, and of points of the surface from the
  /// source. All are 0 without samples.
  double largestFromSource = 0, meanFromSource = 0;
  double largestToSource = 0, meanToSource = 0;
  ///@}
  double sourceVolume = 0; ///< sum over the source's oriented triangles; NaN if they are not closed
  double volume = 0;       ///< the same of the surface
  std::size_t components = 0;        ///< connected parts of the source; 0 for a cloud
  std::size_t lostComponents = 0;    ///< those that the surface has nothing of
  std::size_t selfIntersections = 0; ///< as SelfIntersections.h counts them in the surface
  ///@{
  /// By how much points of the surface are off the distances that are wanted; NaN for none.
  double largestShapeError = std::numeric_limits<double>::quiet_NaN();
  double meanShapeError = std::numeric_limits<double>::quiet_NaN();
  ///@}
};

/// Distances that a surface is to have: the limits of a band about what is in a tree.
struct WantedDistances
{
  const DistanceTree* from;
  DistanceBand band;
};

/// Says in two lines for people what was found, and in a third one how far distances are off.
std::string inWords(const Fidelity& fidelity);

/// Estimates the memory of a comparison with a surface of `triangles` triangles, in bytes.
double bytesForComparison(const Field& field, double triangles, double samples);

/**
 * Compares a surface with the source of a field. Both are sampled evenly by area, or by points if
 * the source is a cloud; the draw depends on the seed, on both of them and on the order of their
 * triangles. Distances are those from the nearest point of the other one, exact up to rounding; the
 * largest is the samples', so a narrow spike may be missed.
 *
 * A part of the source is lost if no corner and no middle of its triangles is as near to the
 * surface as half of `voxel`, and the farthest of the `wanted` distances: it is smaller than the
 * voxels see, or lies inside of another part.
 * Parts are defined in Components.h. The volume of a source with solids that overlap counts what
 * they have in common as often as they do.
 *
 * The points of the surface are compared with the `wanted` distances, unless these are null. The
 * nearer one of a band's limits counts.
 *
 * Time: a distance for each sample and triangle, and of counting self-intersections. Throws
 * Interrupted.
 */
Fidelity compareWithSource(const Field& field, const std::vector<Eigen::Vector3d>& vertices,
  const TriangleList& triangles, double voxel, std::size_t samples, unsigned seed,
  Executor& executor, const WantedDistances* wanted = nullptr);

} // namespace winding
