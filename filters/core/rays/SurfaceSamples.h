// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "source/Surface.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace winding
{

/// A point of a surface.
struct SurfaceSample
{
  std::int32_t triangle;
  double weight; ///< area that it stands for, in any unit
  Eigen::Vector3d position;
  Eigen::Vector3d normal; ///< of unit length
};

/// Points and triangles that represent a surface.
struct SurfaceSamples
{
  std::vector<SurfaceSample> points;  ///< spread over the area
  std::vector<std::int32_t> ordinary; ///< about 256 triangles, chosen evenly by number
  Eigen::Vector3d extents = Eigen::Vector3d::Zero(); ///< of ordinary triangles on average
  Bounds box; ///< of ordinary triangles, where most others are
  /// Triangles that represent all, and none where `shareOfSome` is 1. Long ones are all there
  /// unless they are many, and others are chosen with the probability `shareOfSome`.
  std::vector<std::int32_t> some;
  double shareOfSome = 1;
  bool hasAllLong = false;

  /// Returns the probability that a triangle was chosen.
  double shareOf(const Surface& surface, std::int32_t triangle) const;
};

/**
 * Draws up to twice `most` points of a surface by area, about `most` of a large one. Small surfaces
 * get fewer: 64, and 16 for each triangle.
 *
 * Triangles are chosen by priority sampling (Duffield, Lund and Thorup 2007): each has the priority
 * area / u, with u between 0 and 1 from a hash of its corners, and the highest are taken. So the
 * points depend on the set of triangles alone, neither on their order nor on threads. Triangles
 * without area have none. Of more than 131 072 triangles only SurfaceSamples::some can be chosen.
 * Takes linear time, 10 ns per triangle. Throws Interrupted.
 */
SurfaceSamples sampleSurface(const Surface& surface, std::size_t most, Executor& executor);

/// Returns the normal of a triangle, of unit length, or 0 if it has no area.
Eigen::Vector3d unitNormalOf(const Surface& surface, const Triangle& t);

/// Draws one point for each of some triangles of a surface.
std::vector<SurfaceSample> sampleTriangles(
  const Surface& surface, const std::vector<std::int32_t>& triangles);

/// Returns about `most` of some triangles, in an order that their corners decide.
std::vector<std::int32_t> chooseTriangles(
  const Surface& surface, std::vector<std::int32_t> triangles, std::size_t most);

} // namespace winding
