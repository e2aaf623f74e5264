#pragma once

#include "Executor.h"
#include "Views.h"

#include <Eigen/Geometry>

#include <array>
#include <vector>

/**
 * @file
 * From whatever comes in to sources that every method can trust: finite coordinates, valid ids,
 * vertices with exactly equal coordinates made one. What is dropped is counted, never hidden.
 */
namespace winding
{

using Bounds = Eigen::AlignedBox3d;

/// Three vertex ids; positive orientation is counter-clockwise seen from outside.
using Triangle = std::array<std::int32_t, 3>;

/**
 * A clean triangle chain. Properties: (1) all coordinates are finite and −0 does not occur;
 * (2) no two vertices are equal, every vertex belongs to a triangle, and vertices stand in the order
 * of the input's points, each where the first of those equal to it stood; (3) the three ids of a triangle are valid and differ; (4) triangles keep their order.
 * Duplicate, opposite and zero-area triangles stay: the formulas give them their exact share.
 */
struct Surface
{
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Triangle> triangles;
  Bounds bounds; ///< of the vertices; empty when there are none

  std::size_t inputTriangles = 0;
  std::size_t nonFiniteTriangles = 0; ///< dropped: a corner is NaN or infinite
  std::size_t invalidIdTriangles = 0; ///< dropped: a corner is no point of the input
  std::size_t collapsedTriangles = 0; ///< left out: two corners equal, so they bound nothing

  std::size_t dropped() const { return nonFiniteTriangles + invalidIdTriangles; }
};

/// A clean oriented cloud: finite positions, unit normals, finite non-negative areas.
struct PointCloud
{
  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Vector3d> normals; ///< as many as positions, or none when the input has none
  std::vector<double> areas;            ///< as many as positions, or none when the input has none
  /// Over which points are spread (SolidAngle.h): one per point, or none: pure dipoles, as are those of
  /// length 0. Not of the input: sanitize() leaves it empty.
  std::vector<double> regularizationLengths;
  Bounds bounds;

  std::size_t inputPoints = 0;
  std::size_t nonFinitePoints = 0;  ///< dropped: position, normal or area NaN or infinite
  std::size_t zeroNormalPoints = 0; ///< dropped: a normal of length 0 has no direction
  std::size_t badAreaPoints = 0;    ///< dropped: a negative area

  std::size_t dropped() const { return nonFinitePoints + zeroNormalPoints + badAreaPoints; }
};

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
