// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/DisjointSets.h"
#include "base/Executor.h"
#include "source/Surface.h"
#include "surface/Edges.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace winding
{

/// All edges of a surface in three lists, by the number of triangles that use them. Each list is in
/// the order of (low vertex, high vertex).
struct SurfaceEdges
{
  /// An edge that one triangle uses, which a mesh viewer calls a boundary edge.
  struct Rim
  {
    std::int32_t low, high;
    std::int32_t triangle;
  };

  /// An edge that two triangles use.
  struct Pair
  {
    std::int32_t low, high;
    std::int32_t triangles[2];
    bool agrees; ///< whether both run along the edge in opposite directions, as neighbours should
  };

  /// An edge that more than two triangles use: a non-manifold one.
  struct Crowd
  {
    std::int32_t low, high;
    std::size_t firstUse, endOfUses; ///< range of its uses in crowdUses
  };

  struct Use
  {
    std::int32_t triangle;
    std::int32_t sense; ///< +1 if the triangle runs along the edge from low to high, −1 otherwise
  };

  std::vector<Rim> rims;
  std::vector<Pair> pairs;
  std::vector<Crowd> crowds;
  std::vector<Use> crowdUses; ///< uses of all crowds, each in the order of the triangles

  const Use* begin(const Crowd& crowd) const { return crowdUses.data() + crowd.firstUse; }
  const Use* end(const Crowd& crowd) const { return crowdUses.data() + crowd.endOfUses; }

  /// Returns the sum of the senses of a crowd's uses.
  std::int32_t net(const Crowd& crowd) const
  {
    return std::accumulate(this->begin(crowd), this->end(crowd), std::int32_t(0),
      [](std::int32_t sum, const Use& use) { return sum + use.sense; });
  }

  /// Calls visit(set, net) for each set of triangles that uses the edge of a crowd, in ascending
  /// order, with the sum of the senses of its uses.
  template <class Visit>
  void forEachSet(const Crowd& crowd, DisjointSets& sets, const Visit& visit) const
  {
    std::vector<Use> uses(this->begin(crowd), this->end(crowd));
    for (Use& use : uses)
    {
      use.triangle = sets.find(use.triangle);
    }
    std::sort(
      uses.begin(), uses.end(), [](const Use& a, const Use& b) { return a.triangle < b.triangle; });
    for (auto use = uses.begin(); use != uses.end();)
    {
      const std::int32_t set = use->triangle;
      std::int32_t net = 0;
      for (; use != uses.end() && use->triangle == set; ++use)
      {
        net += use->sense;
      }
      visit(set, net);
    }
  }

  std::size_t size() const { return rims.size() + pairs.size() + crowds.size(); }

  /// Returns the edges as they are once some triangles are turned round; isTurned says by triangle
  /// which are.
  SurfaceEdges withTurned(const std::vector<char>& isTurned) const;
};

/// Finds all edges: the same for every executor. Takes 30 bytes per triangle. Throws Interrupted.
SurfaceEdges edgesOf(const Surface& surface, Executor& executor);

} // namespace winding
