#pragma once

#include "base/Bounds.h"
#include "base/Views.h"
#include "source/PointCloud.h"
#include "source/Surface.h"

#include <vector>

/**
 * @file
 * From whatever comes in to sources that every method can trust: finite coordinates, valid ids,
 * vertices with exactly equal coordinates made one. What is dropped is counted, never hidden.
 */
namespace winding
{

class Executor;

/// Throws Refusal when the arrays of a view differ in length.
void checkLengths(const OrientedPointsView& view);

/**
 * Several views become one source, in their order; the same for every executor. Linear time; for a
 * surface, beside the result, 5 bytes per point of the input and 8 per point that triangles use.
 * Throws Refusal when there was input and every primitive had to be dropped, when a view's arrays
 * differ in length, when there are more than 2³¹ − 1 triangles or vertices remain, or for more than
 * 2³² − 1 points; Interrupted when the executor was.
 */
Surface sanitize(const std::vector<TrianglesView>& views, Executor& executor);
PointCloud sanitize(const std::vector<OrientedPointsView>& views, Executor& executor);

///@{
/// Whether sanitize() keeps a triangle or a point of a view. Those of its surface or cloud are the ones
/// that it keeps, in their order: so what has been found for them goes back to those of the input.
bool isUsable(const TrianglesView& view, std::size_t triangle);
bool isUsable(const OrientedPointsView& view, std::size_t point);
///@}

/// The bounds that sanitize() would find, without building anything; empty for no valid primitive.
Bounds boundsOf(const std::vector<TrianglesView>& views);
Bounds boundsOf(const std::vector<OrientedPointsView>& views);

} // namespace winding
