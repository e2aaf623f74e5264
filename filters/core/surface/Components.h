// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/DisjointSets.h"
#include "source/Surface.h"
#include "surface/SurfaceEdges.h"

namespace winding
{

/**
 * The components of a surface for all that concerns its orientation: sets of triangles that have
 * one sense in common.
 *
 * Triangles that share an edge with no third one belong together. A set that is closed by this rule
 * alone, every edge of it cancelling, is a component: so two cubes that share an edge are two
 * components, each of which may be inside out. Sets that are left open are joined where more than
 * two triangles meet: so rooms with a common wall are one component.
 *
 * A closed set may then be solids that touch, as boxes on one another, with walls of their own.
 * Around an edge each solid lies between two triangles, by their angles (usesByAngle()). The set is
 * divided into these solids where all are closed, which takes faces that look outward.
 *
 * Components are numbered in the order of their first triangles.
 */
struct Components
{
  std::vector<std::int32_t> ofTriangle; ///< component of each triangle
  std::vector<char> isClosed; ///< by component: all of its edges cancel, so its w is an integer

  /// The middle of a triangle (addMiddles()).
  struct Middle
  {
    std::int32_t component;
    double area; ///< in any unit
  };

  /// The middles that there are, which are the last vertices of the surface.
  std::vector<Middle> middles;

  std::size_t size() const { return isClosed.size(); }
};

/// The pieces of a surface that are connected through vertices.
struct VertexPieces
{
  explicit VertexPieces(const Surface& surface)
    : sets(surface.vertices.size())
    , count(surface.vertices.size())
  {
    for (const Triangle& triangle : surface.triangles)
    {
      count -= sets.unite(triangle[0], triangle[1]);
      count -= sets.unite(triangle[1], triangle[2]);
    }
  }

  DisjointSets sets; ///< of vertices
  std::size_t count;
};

/// Finds the components of a surface. The triangles of a polygon, which `parts` names, are in one.
Components componentsOf(
  const Surface& surface, const SurfaceEdges& edges, const PolygonParts& parts = PolygonParts());

/// Returns twice the area of a triangle, whose sides are multiplied by `scale` (UnitScale.h).
double areaOf(const Surface& surface, const Triangle& triangle, double scale);

/// Appends middles of the first `triangles` triangles to a surface's vertices, where `isChosen` is
/// not 0 for their component: of all, or of 2048 to 4096 evenly chosen ones of a large component.
void addMiddles(Surface& surface, Components& components, const std::vector<char>& isChosen,
  std::size_t triangles);

} // namespace winding
