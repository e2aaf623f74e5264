// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/BucketSort.h"
#include "base/Executor.h"
#include "base/UninitializedVector.h"
#include "source/Surface.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace winding
{

/// One side of one triangle, as a use of the edge from its lower to its higher vertex. The lower
/// vertex is not stored: it is known from the place where the use stands.
class EdgeUse
{
public:
  EdgeUse() = default;
  EdgeUse(std::int32_t high, std::size_t triangle, bool runsFromLowToHigh)
    : key_(static_cast<std::uint64_t>(high) << 32 | triangle << 1 | (runsFromLowToHigh ? 1 : 0))
  {
  }

  std::int32_t high() const { return static_cast<std::int32_t>(key_ >> 32); }
  std::int32_t triangle() const { return static_cast<std::int32_t>(key_ >> 1 & 0x7fffffff); }
  int sense() const { return key_ & 1 ? 1 : -1; } ///< +1 if it runs from low to high

  /// Orders uses by high vertex, then by triangle.
  bool operator<(const EdgeUse& other) const { return key_ < other.key_; }

private:
  std::uint64_t key_; ///< high vertex, triangle and sense, so that one comparison sorts by them
};

/// Sorts uses of edges with the same low vertex. No two uses are equal.
void sortUses(EdgeUse* first, EdgeUse* last);

/// Returns whether uses of edges with the same low vertex pair up, one along each edge and one
/// against it. It may say no though all edges cancel, if edges are used more than twice or there
/// are more than 16 uses.
bool pairUp(const EdgeUse* first, const EdgeUse* last);

/**
 * All uses of all edges of triangles over welded vertices, edge by edge. Triangles are distributed
 * to ranges of vertices by the low vertices of their sides; the uses of a range are made when it is
 * visited, and sorted by counting, then by the high vertex in small sorts. This takes linear time
 * for bounded vertex degrees, 8 bytes per triangle, and about 60 per vertex of a range while it is
 * visited.
 */
class EdgeUses
{
public:
  /// Keeps a reference to the surface, which must outlive this. Throws Interrupted.
  EdgeUses(const Surface& surface, Executor& executor);

  /// Calls visit(low, first, last) for every edge, with its uses in [first, last), in the order of
  /// (low, high); the uses of an edge are in the order of the triangles.
  template <class Visit> void forEachEdge(const Visit& visit) const
  {
    for (std::size_t range = 0; range < this->ranges(); ++range)
    {
      this->forEachVertex(range, [&visit](std::int32_t low, EdgeUse* first, EdgeUse* last)
        { forEachEdge(low, first, last, visit); });
    }
  }

  /// The number of ranges that may be visited in parallel. The vertices of the ranges, one
  /// range after the other, are all vertices in their order.
  std::size_t ranges() const { return numbers_.count() / 2; }

  /// Calls visit(low, first, last) for every vertex of a range, with the uses of all edges whose
  /// low vertex it is in [first, last). The uses are unsorted; the visitor may sort them.
  template <class Visit> void forEachVertex(std::size_t range, const Visit& visit) const
  {
    UsesOfRange uses = this->usesOf(range);
    EdgeUse* first = uses.uses.data();
    std::int32_t low = uses.firstLow;
    for (const std::size_t end : uses.ends)
    {
      EdgeUse* const last = uses.uses.data() + end;
      visit(low, first, last);
      first = last;
      ++low;
    }
  }

  /// Sorts the uses of edges with one low vertex, and calls visit(low, first, last) for each of
  /// these edges in their order.
  template <class Visit>
  static void forEachEdge(std::int32_t low, EdgeUse* first, EdgeUse* end, const Visit& visit)
  {
    sortUses(first, end);
    while (first != end)
    {
      const EdgeUse* const edge = first;
      while (first != end && first->high() == edge->high())
      {
        ++first;
      }
      visit(low, edge, const_cast<const EdgeUse*>(first));
    }
  }

private:
  struct UsesOfRange
  {
    std::int32_t firstLow;
    std::vector<std::size_t> ends; ///< by low vertex: where its uses end and the next one's begin
    UninitializedVector<EdgeUse> uses;
  };

  UsesOfRange usesOf(std::size_t range) const;

  const TriangleList& triangles_;
  std::size_t vertices_;
  int shift_; ///< range = vertex >> shift
  /// Numbers of triangles: bucket 2 · range has those whose lowest vertex is in the range, which is
  /// the low vertex of two sides, and the next bucket those whose middle vertex is in it, the low
  /// vertex of the third side. The two are kept apart so that no branch depends on which it is.
  Buckets<std::uint32_t> numbers_;
};

} // namespace winding
