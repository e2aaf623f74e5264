// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Choices.h"
#include "base/InsideRule.h"
#include "field/Field.h"
#include "source/Grid.h"
#include "support/Shapes.h"

#include <memory>
#include <vector>

/**
 * @file
 * Random sources and samples, small ones, in which everything occurs that is hard on a method:
 * faces, edges and vertices in grid planes, duplicates, opposite and degenerate triangles, fans,
 * needles, coordinates that are huge, tiny or far from the origin, and what is no number at all.
 */
namespace fuzz
{

/// A mesh of at most `mostTriangles` triangles. Some meshes have unusable triangles.
shapes::Mesh randomMesh(Choices& choices, int mostTriangles);

/// A mesh that is closed and has only the triangles of a solid, oriented outward.
shapes::Mesh randomSolid(Choices& choices);

/// Points with normals, and areas unless that is empty.
struct RandomCloud
{
  shapes::Cloud cloud;
  std::vector<double> areas;

  winding::OrientedPointsView view() const;
};

/// A cloud of 1 to `mostPoints` points.
RandomCloud randomCloud(Choices& choices, int mostPoints);

/// The field of a random mesh or cloud by any method; null where it is refused.
std::shared_ptr<const winding::Field> randomField(Choices& choices);

/// A grid of at most 6 samples along each axis, about the bounds of a source, which must not be
/// empty. Often its planes go through vertices.
winding::Grid randomGrid(Choices& choices, const winding::Bounds& bounds);

/// An extent of a grid, not empty.
winding::Extent randomExtent(Choices& choices, const winding::Grid& grid);

/// Samples around the vertices of a source, some on them and between them, some far away. Finite.
std::vector<shapes::Point> randomSamples(
  Choices& choices, const std::vector<shapes::Point>& vertices, int count);

winding::InsideRule randomRule(Choices& choices);

/// A threshold from 0.05 to 1.5, mostly 0.5.
double randomThreshold(Choices& choices);

/// A tolerance from 1e-2 to 1e-6.
double randomTolerance(Choices& choices);

/// The views of a mesh or cloud as Field::build() takes them.
std::vector<winding::TrianglesView> viewsOf(const shapes::Mesh& mesh);
std::vector<winding::OrientedPointsView> viewsOf(const RandomCloud& cloud);

} // namespace fuzz
