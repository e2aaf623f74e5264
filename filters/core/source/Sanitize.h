// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "base/Views.h"
#include "source/PointCloud.h"
#include "source/Surface.h"

#include <vector>

/**
 * @file
 * Makes sources that every method can trust from whatever comes in: coordinates are in range, ids
 * are valid, and vertices with exactly equal coordinates are made one. Dropped primitives are
 * counted, never hidden. Numbers that are finite but out of range are refused, since products of
 * lengths would overflow or vanish, and the value and the number of the point are named.
 */
namespace winding
{

class Executor;

/// The largest size of a coordinate that a source may have.
constexpr double largestCoordinate = 1e100;

/// The smallest length of the longest side of a source's bounds, unless the source is one place.
constexpr double smallestSize = 1e-100;

/**
 * The largest area that a point of a cloud of these bounds may have: 1e30 times the square of their
 * longest side, but 1e210 at most and for a cloud that is one place. Areas of meshes of the largest
 * coordinates stay below 1e210, and a factor of 1e30 keeps w in the range of float except near
 * points.
 */
double largestArea(const Bounds& bounds);

/// Throws Refusal when the arrays of a view differ in length.
void checkLengths(const OrientedPointsView& view);

/// Whether any of some normals is finite and not 0. Programs write zeros where they have none.
bool haveDirections(const VectorsView& normals);

/// Takes the normals away from views if none has any direction, so that they lack normals.
void removeEmptyNormals(std::vector<OrientedPointsView>& views);

/**
 * Makes one source of several views, in their order; the source is the same for every executor.
 * Takes linear time and, for a surface, 5 bytes per point of the input and 8 per point that
 * triangles use, in addition to the result. Throws Refusal when there was input and every primitive
 * had to be dropped, when a number is out of range (points that no triangle uses count for clouds
 * only), when a view's arrays differ in length, when there are more than 2³¹ − 1 triangles or
 * vertices remain, or for more than 2³² − 1 points; throws Interrupted when the executor was
 * interrupted. A cloud whose normals all have length 0 becomes one without normals.
 */
Surface sanitize(const std::vector<TrianglesView>& views, Executor& executor);
PointCloud sanitize(const std::vector<OrientedPointsView>& views, Executor& executor);

///@{
/// Whether sanitize() keeps a triangle or a point of a view. The primitives of its surface or cloud
/// are the kept ones, in their order; so results for them can be given back to the primitives of
/// the input.
bool isUsable(const TrianglesView& view, std::size_t triangle);
bool isUsable(const OrientedPointsView& view, std::size_t point);
///@}

/// Returns which triangles are parts of one polygon, in the surface that sanitize() makes.
PolygonParts polygonPartsOf(const std::vector<TrianglesView>& views);

///@{
/// The bounds that sanitize() would find, without building anything; empty for no valid primitive.
/// Throws Refusal for coordinates out of range, and when a view's arrays differ in length; with an
/// executor, Interrupted.
Bounds boundsOf(const std::vector<TrianglesView>& views);
Bounds boundsOf(const std::vector<OrientedPointsView>& views);
Bounds boundsOf(const std::vector<TrianglesView>& views, Executor& executor);
Bounds boundsOf(const std::vector<OrientedPointsView>& views, Executor& executor);
///@}

} // namespace winding
