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
  Eigen::Vector3d normal;   ///< of unit length
};

/// Points that stand for a surface.
struct SurfaceSamples
{
  std::vector<SurfaceSample> points; ///< spread over the area
  Eigen::Vector3d extents = Eigen::Vector3d::Zero(); ///< of triangles on average
  /// Triangles that stand for all, each chosen with the probability `shareOfSome`, and none where
  /// that is 1.
  std::vector<std::int32_t> some;
  double shareOfSome = 1;
};

/**
 * Draws up to twice `most` points of a surface by area, about `most` of a large one. Small surfaces
 * get fewer: 64, and 16 for each triangle.
 *
 * Triangles are chosen by priority sampling (Duffield, Lund and Thorup 2007): each has the priority
 * area / u, with u between 0 and 1 from a hash of its corners, and the highest are taken. So the
 * points depend on the set of triangles alone, neither on their order nor on threads. Triangles
 * without area have none. Takes linear time, 10 ns per triangle. Throws Interrupted.
 */
SurfaceSamples sampleSurface(const Surface& surface, std::size_t most, Executor& executor);

/// Returns the normal of a triangle, of unit length, or 0 if it has no area.
Eigen::Vector3d unitNormalOf(const Surface& surface, const Triangle& t);

/// Draws one point for each of some triangles of a surface.
std::vector<SurfaceSample> sampleTriangles(
  const Surface& surface, const std::vector<std::int32_t>& triangles);

/// Returns the numbers of about `most` triangles among `triangles`, which their corners choose.
std::vector<std::int32_t> chooseTriangles(
  const Surface& surface, std::vector<std::int32_t> triangles, std::size_t most);

} // namespace winding
