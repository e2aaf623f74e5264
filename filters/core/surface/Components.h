#pragma once

#include "source/Surface.h"
#include "surface/SurfaceEdges.h"

namespace winding
{

/**
 * The components of a surface for all that concerns its orientation: what has one sense of its own.
 *
 * Triangles that share an edge with no third one belong together. What is closed by that alone, every
 * edge of it cancelling, is a component: so two cubes that share an edge are two, each of which may be
 * inside out. What is left open is joined where more than two triangles meet: rooms with a common wall
 * are one. Components are numbered in the order of their first triangles.
 */
struct Components
{
  std::vector<std::int32_t> ofTriangle;
  std::vector<char> isClosed; ///< by component: all of its edges cancel, so its w is an integer

  std::size_t size() const { return isClosed.size(); }
};

/**
 * Which triangles are parts of one polygon: by triangle, whether it belongs to that of the triangle
 * before. Empty: each is a polygon of its own. The triangles of a polygon are in one component, for
 * they have their sense in common.
 */
using PolygonParts = std::vector<char>;

Components componentsOf(
  const Surface& surface, const SurfaceEdges& edges, const PolygonParts& parts = PolygonParts());

} // namespace winding
