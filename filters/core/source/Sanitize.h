#pragma once

#include "base/Bounds.h"
#include "base/Views.h"
#include "source/PointCloud.h"
#include "source/Surface.h"

#include <vector>

/**
 * @file
 * Makes sources that every method can trust from whatever comes in: coordinates are finite, ids are
 * valid, and vertices with exactly equal coordinates are made one. Dropped primitives are counted,
 * never hidden.
 */
namespace winding
{

class Executor;

/// Throws Refusal when the arrays of a view differ in length.
void checkLengths(const OrientedPointsView& view);

/**
 * Makes one source of several views, in their order; the source is the same for every executor.
 * Takes linear time and, for a surface, 5 bytes per point of the input and 8 per point that
 * triangles use, beside the result. Throws Refusal when there was input and every primitive had to
 * be dropped, when a view's arrays differ in length, when there are more than 2³¹ − 1 triangles or
 * vertices remain, or for more than 2³² − 1 points; throws Interrupted when the executor was
 * interrupted.
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

/// The bounds that sanitize() would find, without building anything; empty for no valid primitive.
Bounds boundsOf(const std::vector<TrianglesView>& views);
Bounds boundsOf(const std::vector<OrientedPointsView>& views);

} // namespace winding
