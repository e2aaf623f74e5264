#pragma once

#include "base/Executor.h"
#include "source/Surface.h"
#include "surface/Edges.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace winding
{

/// All edges of a surface, apart by how many triangles use them, each list in the order of
/// (low vertex, high vertex).
struct SurfaceEdges
{
  /// Used by one triangle: what a mesh viewer calls the boundary.
  struct Rim
  {
    std::int32_t low, high;
    std::int32_t triangle;
  };

  /// Used by two.
  struct Pair
  {
    std::int32_t low, high;
    std::int32_t triangles[2];
    bool agrees; ///< whether they run along it in opposite directions, as neighbours should
  };

  /// Used by more: what is called non-manifold.
  struct Crowd
  {
    std::int32_t low, high;
    std::size_t firstUse, endOfUses; ///< in crowdUses
  };

  struct Use
  {
    std::int32_t triangle;
    std::int32_t sense; ///< +1 if the triangle runs along it from low to high, −1 the other way
  };

  std::vector<Rim> rims;
  std::vector<Pair> pairs;
  std::vector<Crowd> crowds;
  std::vector<Use> crowdUses; ///< those of a crowd in the order of the triangles

  const Use* begin(const Crowd& crowd) const { return crowdUses.data() + crowd.firstUse; }
  const Use* end(const Crowd& crowd) const { return crowdUses.data() + crowd.endOfUses; }

  std::size_t size() const { return rims.size() + pairs.size() + crowds.size(); }

  /// As the edges are when some triangles run the other way round: by triangle, whether it does.
  SurfaceEdges withTurned(const std::vector<char>& isTurned) const;
};

/// The same for every executor. 30 bytes per triangle. Throws Interrupted.
SurfaceEdges edgesOf(const Surface& surface, Executor& executor);

} // namespace winding
