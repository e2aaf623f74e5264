// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "source/Surface.h"
#include "surface/BoundaryLoops.h"
#include "surface/SurfaceEdges.h"

#include <optional>
#include <vector>

namespace winding
{

/**
 * The widths of what a surface leaves open, by the edges of one triangle (SurfaceEdges::rims).
 *
 * The width at a point of an edge is its distance from the nearest of these edges that runs the
 * opposite way: the dot product of their directions is negative. The width of an edge is the
 * largest at its two ends and its middle. It is 0 where a slit ends, the slit's width along a slit,
 * and about the hole's width at a hole. Where no edge runs the opposite way it is the diagonal of
 * the bounds. Each point looks at 500 boxes and edges at most, the nearest first. So where
 * thousands of edges are about equally near, as in soups of large triangles, widths may be too
 * large.
 *
 * Directions are the triangles' own. So the two sides of a slit cancel in the boundary chain where
 * widths are small. A triangle that is turned the wrong way leaves it open, and makes it wide.
 *
 * Guaranteed: the bits are the same for any executor, any order of triangles and any first corners
 * of these, and for coordinates times a power of two, which the widths are multiplied with.
 */
struct Slits
{
  std::vector<double> widths; ///< by edge, in the order of SurfaceEdges::rims

  /// The distances, by edge, of its ends from the ends of the edge that is nearest to its middle
  /// and runs the opposite way. An edge has an opposite of its own where both distances are small.
  std::vector<double> endDistances;

  /// Returns the largest width; none without edges.
  std::optional<double> widest() const;
};

/// Measures slits. Takes O(n log n) time and 300 bytes for each of n edges of one
/// triangle. Throws Interrupted.
Slits slitsOf(const Surface& surface, const SurfaceEdges& edges, Executor& executor);

/// Returns the largest width of the edges of one triangle that a loop runs along; none where there
/// are none.
std::optional<double> widestAlong(
  const BoundaryLoop& loop, const SurfaceEdges& edges, const Slits& slits);

/// Returns the median length of the edges of a surface; 0 without edges. Throws Interrupted.
double medianEdgeLength(const Surface& surface, const SurfaceEdges& edges, Executor& executor);

} // namespace winding
