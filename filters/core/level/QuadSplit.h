// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace winding
{

/// The ways to cut a quad around an edge of a grid into triangles.
enum class QuadSplit
{
  first,  ///< along the diagonal from corner 0 to corner 2
  second, ///< along the diagonal from corner 1 to corner 3
  fan     ///< into four, around a vertex at the crossing of the edge
};

/// A quad and its edge in coordinates of the edge: the first two across it, the third along it,
/// from 0 to 1.
struct QuadAroundEdge
{
  /// One in each quadrant: before the edge along both axes, behind it along the first, along both,
  /// along the second. None lies on a plane between quadrants.
  Eigen::Vector3d corners[4];
  double crossing;         ///< place of the surface's crossing on the edge
  Eigen::Vector3d spacing; ///< length of a unit of each coordinate
};

/**
 * The better way to cut a quad: along the diagonal whose triangles cross the edge nearest to the
 * surface's crossing, which is the one that follows a sharp edge of the surface; among equally near
 * ones, along the shorter diagonal.
 *
 * Triangles stay in the four tetrahedra that the edge spans with the sides of the quad (Ju, Udeshi,
 * Intersection-free contouring on an octree grid, 2006). These have no inner points in common with
 * other edges', if each cell has one vertex, so no two triangles of a surface pass through
 * each other. A diagonal that would leave them, or come so near to it that rounding to single
 * precision might, is not taken; a fan always stays inside.
 */
QuadSplit betterSplit(const QuadAroundEdge& quad);

} // namespace winding
