// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/Views.h"
#include "report/Hollow.h"
#include "source/Surface.h"
#include "surface/Openings.h"
#include "surface/Slits.h"
#include "surface/SurfaceEdges.h"

#include <optional>

namespace winding
{

/// Counts of the edges of the welded surface, by the triangles that use them.
struct EdgeCounts
{
  std::size_t edges = 0;
  std::size_t boundary = 0;      ///< edges used by one triangle
  std::size_t netBoundary = 0;   ///< edges used more often in one direction than in the other
  std::size_t nonManifold = 0;   ///< edges used by more than two triangles
  std::size_t inconsistent = 0;  ///< edges used by two triangles in the same direction
  std::size_t boundaryLoops = 0; ///< connected pieces of the boundary edges
  std::size_t components = 0;    ///< pieces of the surface connected through edges

  /// Whether every edge cancels: then w is an integer everywhere off the surface.
  bool isClosed() const { return netBoundary == 0; }
};

EdgeCounts countEdges(const Surface& surface, const SurfaceEdges& edges);

/// Counts of the components of a surface by their orientation (Components.h, ClosedComponents.h,
/// Orientation.h). Open components have sides, too, where they are nearly closed (NearlyClosed.h):
/// w near them is about 1 inside and 0 outside, or −1 inside if they are inverted.
struct OrientationCounts
{
  std::size_t closed = 0;         ///< components whose edges cancel
  std::size_t nearlyClosed = 0;   ///< open components that a cap closes
  std::size_t inverted = 0;       ///< both kinds of them, inward inside an even number of others
  std::size_t nestedSolids = 0;   ///< both kinds of them, outward inside an odd number of others
  std::size_t contradictions = 0; ///< edges at which triangles disagree, though turning would help
  std::size_t oneSided = 0;       ///< parts that no turning could make agree
};

/// The health of a surface. The counts of dropped triangles are in the Surface.
struct SurfaceReport
{
  EdgeCounts edges;
  OrientationCounts orientation;
  std::size_t vertexComponents = 0;   ///< pieces of the surface connected through vertices
  std::size_t duplicateTriangles = 0; ///< triangles of faces that are there before
  std::size_t mendableTriangles = 0;  ///< of these, the ones that Orientation.h leaves out
  bool isTwoSided = false;            ///< whether all faces are there in both senses
  std::size_t openPartsInside = 0;    ///< open parts inside of closed ones (OpenParts.h)
  std::size_t zeroAreaTriangles = 0;  ///< triangles with three different vertices on a line
  Openings openings;                  ///< left to the caller, who has the boundary chain
  Slits slits;                        ///< of the boundary edges, by edge
  std::optional<double> widestSlit;   ///< width of the widest; none without boundary edges
  double medianEdgeLength = 0;        ///< of all edges; measured where there are boundary edges
  double area = 0;                    ///< of all triangles except repeated ones
  /// The integral of w over space, which counts overlaps as often as they are there. It means
  /// something for closed surfaces only.
  double volume = 0;
  double wallThickness = 0;     ///< by that function of Hollow.h; left to the caller
  std::optional<Hollow> hollow; ///< of a surface with thin walls; left to the caller
  double shareOnce = 1; ///< of that, each place counted once (SampleShares.h); left to the caller

  /// The number V − E + F of vertices, edges and triangles: 2 for a sphere, 0 for a torus.
  long long eulerCharacteristic = 0;

  /// Whether the boundary is of slits alone, all of them narrower than a thousandth of the median
  /// edge. Triangles run along all other edges as often in one sense as in the other then.
  bool isClosedExceptForSlits() const;

  /// Whether to make near points one closes these slits: each edge has an opposite whose ends are
  /// as near. Otherwise vertices of one side lie on edges of the other.
  bool canBeWelded() const;
};

/// Examines a surface; the report is the same for every executor. `parts` says which triangles are
/// of one polygon. Throws Interrupted.
SurfaceReport reportOn(const Surface& surface, const SurfaceEdges& edges, Executor& executor,
  const PolygonParts& parts = PolygonParts());

/// Counts of the points that a surface was made from, whether triangles use them or not.
struct VertexCounts
{
  std::size_t points = 0;
  std::size_t different = 0;    ///< finite positions, equal ones counted once
  std::size_t unreferenced = 0; ///< different positions that no triangle of the surface uses
};

/// Counts the points of the views that the surface was made from. Takes O(n log n) time, and 100
/// bytes per point while it runs. Throws Interrupted.
VertexCounts countVertices(
  const std::vector<VectorsView>& points, const Surface& surface, Executor& executor);

} // namespace winding
