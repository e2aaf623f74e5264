// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level/EdgeRoots.h"

#include <cstdint>
#include <vector>

namespace winding
{

/// An operand of an operation on solids: its edges and their roots.
struct LevelOperand
{
  const LevelEdges* edges;
  const EdgeRoots* roots;
};

/**
 * The roots of the result of an operation on solids (LevelEdges). On an edge of the result one or
 * more operands change from inside to outside, or back. The root is the first of their roots, from
 * the first sample on, at which the result changes; so it lies exactly on that operand. Operands at
 * the same place count in their order.
 *
 * Guaranteed: the bits are the same for every executor. Time: n log n in the edges of each row.
 */
struct CombinedRoots
{
  /// Finds the roots of `edges`, the edges of the result of `operation`. Throws Interrupted.
  CombinedRoots(const LevelEdges& edges, const std::vector<LevelOperand>& parts,
    BooleanOperation operation, Executor& executor);

  EdgeRoots roots;
  std::vector<std::uint32_t> operands; ///< the number of the operand that each root lies on
};

/// Returns the operand of a triangle, whose corners are numbers of edges: the one that two of them
/// have, or the first one's. `operands` are the numbers that CombinedRoots has for edges.
std::uint32_t operandOf(const std::int64_t* corners, const std::vector<std::uint32_t>& operands);

} // namespace winding
