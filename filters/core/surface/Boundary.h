#pragma once

#include "base/Executor.h"
#include "source/Surface.h"

#include <vector>

/**
 * @file
 * The boundary chain ∂M: what remains of all triangle sides after those that run along the same edge
 * in opposite directions have cancelled. It exists for every chain of triangles, manifold or not,
 * consistently oriented or not, and it is 0 exactly where the winding number is an integer.
 */
namespace winding
{

/// An edge of ∂M, from → to, `multiplicity` times, at least once.
struct BoundaryEdge
{
  std::int32_t from, to;
  std::int32_t multiplicity;
};

struct BoundaryChain
{
  /// In the order of (lower vertex, higher vertex); each undirected edge occurs once at most. At
  /// every vertex as many edges leave as arrive, counted with multiplicity.
  std::vector<BoundaryEdge> edges;

  /// Edges that one triangle uses: what a mesh viewer calls its boundary. All of them are in the
  /// chain, together with those where orientations disagree or triangles meet in odd numbers.
  std::size_t edgesOfOneTriangle = 0;
};

/// The same for every executor. Throws Interrupted.
BoundaryChain boundaryChain(const Surface& surface, Executor& executor);

/// A closed walk v₀ → v₁ → … → v₀ along boundary edges that visits no vertex twice; at least three.
using BoundaryLoop = std::vector<std::int32_t>;

/// Splits a chain into loops: together they run along each edge as often as its multiplicity says.
std::vector<BoundaryLoop> boundaryLoops(const BoundaryChain& chain, std::size_t vertices);

} // namespace winding
