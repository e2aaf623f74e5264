// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Views.h"
#include "source/Surface.h"
#include "support/Samples.h"
#include "surface/Boundary.h"

#include <array>
#include <functional>
#include <set>
#include <vector>

/**
 * @file
 * Test shapes, made in code. Closed ones are oriented outward.
 */
namespace shapes
{

struct Mesh
{
  std::vector<Point> points;
  std::vector<std::array<std::int32_t, 3>> triangles;

  /// A view that is valid while the mesh lives and keeps its size.
  winding::TrianglesView view() const;
  /// Every triangle (a, b, c) becomes (a, c, b).
  Mesh reversed() const;
  Mesh mapped(const std::function<Point(const Point&)>& map) const;
  Mesh moved(const Point& by) const;
  Mesh scaled(double factor) const;
  /// Both meshes in one, without shared points.
  Mesh with(const Mesh& other) const;
  /// The mesh with only the triangles first … last − 1.
  Mesh part(std::size_t first, std::size_t last) const;
};

/// The surface of a mesh without bad primitives.
winding::Surface clean(const Mesh& mesh);

/// The surface of a mesh times a factor, which may take coordinates out of the range that a source
/// may have.
winding::Surface cleanScaled(const Mesh& mesh, double factor);

winding::BoundaryChain boundaryOf(const winding::Surface& surface);

Mesh tetrahedron();
Mesh cube(const Point& low = {0, 0, 0}, const Point& high = {1, 1, 1});
/// The unit cube without the two triangles at z = 1.
Mesh openCube();
/// The unit cube, the side x = 1 of which has points of its own, `width` away from the others.
Mesh cubeWithSlit(double width);
/// A sphere of radius 1 with 20 · 4^levels triangles.
Mesh icosphere(int levels);
Mesh ball(const Point& center, double radius, int levels = 2);
/// A torus of radii 1 and 0.4 around the z axis.
Mesh torus(int along, int around);
/// A body of two walls: the faces of `outer` and, `wall` times as far from the origin, the same
/// faces reversed. Tubes replace some of these faces, which are named by their number.
Mesh doubleWalls(const Mesh& outer, double wall, const std::vector<std::size_t>& openings);
/// A surface of revolution around z through circles of {radius, height}, open at its ends unless
/// the radius is 0 there. It looks outward if heights ascend.
Mesh lathe(const std::vector<std::array<double, 2>>& profile, int corners);
/// A band of `quads` quadrilaterals that closes with a half twist.
Mesh moebiusStrip(int quads);
/// Triangles on one edge; every other one runs back along it if `byTurns`.
Mesh book(std::int32_t pages, bool byTurns = false);
/// Triangles without any relation, of all sizes from about 2^−8 to 1, within [−2, 2]³.
Mesh triangleSoup(std::size_t count, unsigned seed);

/// Solids are sets of lattice cubes: their surface is known, and so is what is inside.
using Cell = std::array<int, 3>;
using Cells = std::set<Cell>;
Cells lShape();
/// Each of n³ cells with probability ½; the solid is full of edges and vertices that are not
/// manifold.
Cells randomCells(int n, unsigned seed);
Mesh surfaceOf(const Cells& cells);
/// The winding number at any point; on the surface, the share of the solid around the point.
double windingOf(const Cells& cells, const Point& point);

/// Points at a distance from random places well within random triangles, on random sides.
std::vector<Point> pointsNear(const Mesh& mesh, std::size_t count, double distance, unsigned seed);

} // namespace shapes
