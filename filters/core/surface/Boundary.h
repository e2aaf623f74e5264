// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "source/Surface.h"

#include <vector>

/**
 * @file
 * The boundary chain ∂M: what remains of all triangle sides after those that run along the same
 * edge in opposite directions have cancelled. It exists for every chain of triangles, manifold or
 * not, consistently oriented or not, and it is 0 exactly if the winding number is an integer
 * everywhere off the triangles.
 */
namespace winding
{

/// An edge of ∂M, which runs from → to `multiplicity` times, at least once.
struct BoundaryEdge
{
  std::int32_t from, to;
  std::int32_t multiplicity;
};

using BoundaryEdges = UninitializedVector<BoundaryEdge>;

/// An edge that two triangles use in the same sense.
struct Contradiction
{
  std::int32_t low, high; ///< its vertices
  std::int32_t triangles[2];
};

struct BoundaryChain
{
  /// The edges stand in the order of (lower vertex, higher vertex), which depends on the numbers of
  /// vertices; sortedByCoordinates() gives them one that does not. Each undirected edge occurs
  /// once at most. At every vertex as many edges leave as arrive, counted with multiplicity.
  BoundaryEdges edges;

  /// The number of edges that one triangle uses, which a mesh viewer calls the boundary. All of
  /// them are in the chain, together with edges where orientations disagree or triangles meet in
  /// odd numbers.
  std::size_t edgesOfOneTriangle = 0;

  /// The edges that two triangles use in the same sense, in the order of (lower vertex, higher
  /// vertex).
  std::vector<Contradiction> contradictions;

  /// The ends of all edges that more than two triangles use, or two in the same sense: each edge of
  /// a triangle that is there more than once is one of these, except for two opposite triangles
  /// that no other touches. A vertex may be listed several times.
  std::vector<std::int32_t> crowdedVertices;
};

/// Sorts edges by the coordinates of their lower, then of their higher end, by x, y and z: an order
/// that depends neither on the numbers of vertices nor on the directions of edges, and stays where
/// the source is moved. Each undirected edge may stand there once at most.
/// Throws Interrupted.
BoundaryEdges sortedByCoordinates(
  const BoundaryEdges& edges, const std::vector<Eigen::Vector3d>& vertices, Executor& executor);

/// Makes the boundary chain of a surface: the same for every executor. Throws Interrupted.
BoundaryChain boundaryChain(const Surface& surface, Executor& executor);

} // namespace winding
