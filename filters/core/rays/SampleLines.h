// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rays/SurfaceSamples.h"

#include <limits>
#include <vector>

namespace winding
{

/// The surfaces that a line through a point meets. "Before" is where the normal points, "behind"
/// the other side. Where the surface is closed, both ends of the line agree.
struct SampleLine
{
  int before = 0; ///< winding number just before the point, counted from that end of the line
  int behind = 0; ///< winding number just behind the point, counted from the other end
  int step = 0;   ///< times that the surface is there, less the times with the other sense
  bool isRepeated = false; ///< whether another triangle is there that shares an edge's corners
  int facesBefore = 0, facesBehind = 0; ///< triangles in either direction, whatever their sense
  int times = 0;                        ///< times that these triangles are there, all together
  /// The thickness of the wall behind the point, from the next triangle there, taken as parallel or
  /// as the other side of a rod. It is infinite where that triangle looks the same way.
  double wall = std::numeric_limits<double>::infinity();
  /// The same where that triangle looks the same way: the distance to another solid that begins.
  double entry = std::numeric_limits<double>::infinity();
  std::int32_t wallTriangle = -1; ///< the next triangle behind the point; −1 for none

  /// Returns whether both ends agree with each other.
  bool isClear() const { return behind == before + step; }
};

/// A triangle that a line along an axis meets.
struct LineHit
{
  std::int32_t sample; ///< that the line runs through
  std::int32_t triangle;
  int times;    ///< times that it is there; less than 0 if it looks against the axis
  double place; ///< along the axis
};

/// Returns the axis of the line through a sample, which is the nearest to the normal.
int axisOf(const SurfaceSample& sample);

/// Finds all triangles that lines along axes meet, ordered by triangle, as linesThrough() does. The
/// lines run through `samples`, which need not be on the surface.
std::vector<LineHit> hitsOfLines(const Surface& surface, const std::vector<SurfaceSample>& samples,
  const SurfaceSamples& all, Executor& executor, const std::vector<std::int32_t>* some = nullptr);

/**
 * Finds what lines through some points of a surface meet. A line runs along axisOf() its point.
 * Triangles as near as 1e-6 times the longest side of the bounds are at the point. `all` are
 * samples of the same surface.
 *
 * Lines meet no other triangles than `some`, where these are given. So a triangle is met with the
 * probability that it was chosen by.
 *
 * Crossings of closed chains cancel whatever the rounding, since triangles share the decision about
 * an edge. Takes 20 ns per triangle, and as long for each test of a line by a triangle in the same
 * bins, which affordableShare() limits. Throws Interrupted.
 */
std::vector<SampleLine> linesThrough(const Surface& surface,
  const std::vector<SurfaceSample>& samples, const SurfaceSamples& all, Executor& executor,
  const std::vector<std::int32_t>* some = nullptr);

/// Returns the share of lines through `samples` that linesThrough() tests no more than n/4 + 2^15 +
/// `more` times by n triangles, as the ordinary triangles of `all` let expect.
double affordableShare(const Surface& surface, const std::vector<SurfaceSample>& samples,
  const SurfaceSamples& all, double more = 0);

} // namespace winding
