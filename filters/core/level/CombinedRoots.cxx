// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/CombinedRoots.h"

#include <algorithm>

namespace winding
{

namespace
{

constexpr std::size_t edgesPerBlock = 4096;

/// An operand that changes on an edge of the result.
struct Change
{
  std::uint32_t operand;
  std::size_t edge; ///< of the operand
  double fraction;
};

/// Finds the operands that change on an edge, by ascending fraction.
void findChanges(
  const GridEdge& edge, const std::vector<LevelOperand>& operands, std::vector<Change>& changes)
{
  changes.clear();
  for (std::size_t n = 0; n < operands.size(); ++n)
  {
    const std::size_t found = operands[n].edges->find(edge.sample, edge.axis);
    if (found < operands[n].edges->size())
    {
      changes.push_back(
        {static_cast<std::uint32_t>(n), found, operands[n].roots->fractions[found]});
    }
  }
  std::stable_sort(changes.begin(), changes.end(),
    [](const Change& a, const Change& b) { return a.fraction < b.fraction; });
}

/// Returns the first change at which the result changes, walking from the first sample of the edge
/// to the second.
const Change& changeOfResult(const GridEdge& edge, const std::vector<Change>& changes,
  const std::vector<LevelOperand>& operands, BooleanOperation operation)
{
  if (changes.size() == 1)
  {
    return changes.front();
  }
  std::vector<char> isInside;
  std::size_t inside = 0;
  for (const LevelOperand& operand : operands)
  {
    isInside.push_back(operand.edges->isSampleInside(edge.sample));
    inside += isInside.back() != 0;
  }
  for (const Change& change : changes)
  {
    char& changed = isInside[change.operand];
    changed = !changed;
    inside = changed ? inside + 1 : inside - 1;
    if (isInResult(operation, operands.size(), inside, isInside.front() != 0) != edge.firstIsInside)
    {
      return change;
    }
  }
  return changes.back();
}

} // namespace

CombinedRoots::CombinedRoots(const LevelEdges& edges, const std::vector<LevelOperand>& parts,
  BooleanOperation operation, Executor& executor)
  : roots(edges.size())
  , operands(edges.size())
{
  runBlocks(
    edges.size(), edgesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      std::vector<Change> changes;
      for (std::size_t edge = first; edge < last; ++edge)
      {
        findChanges(edges[edge], parts, changes);
        const Change& change = changeOfResult(edges[edge], changes, parts, operation);
        roots.fractions[edge] = change.fraction;
        roots.normals[edge] = parts[change.operand].roots->normals[change.edge];
        operands[edge] = change.operand;
      }
    },
    executor);
}

std::uint32_t operandOf(const std::int64_t* corners, const std::vector<std::uint32_t>& operands)
{
  const auto of = [&](std::size_t corner)
  {
    return operands[static_cast<std::size_t>(corners[corner])];
  };
  return of(1) == of(2) ? of(1) : of(0);
}

} // namespace winding
