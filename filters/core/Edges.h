#pragma once

#include "Sanitize.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace winding
{

/// One side of one triangle, as a use of the edge from its lower to its higher vertex.
struct EdgeUse
{
  std::int32_t high; ///< the higher vertex; the lower one is the use's place in EdgeUses
  std::uint32_t triangleAndSense; ///< triangle · 2 + 1 if it runs from low to high

  std::int32_t triangle() const { return static_cast<std::int32_t>(triangleAndSense >> 1); }
  int sense() const { return triangleAndSense & 1 ? 1 : -1; }
};

/**
 * All uses of all edges of triangles over welded vertices, sorted by edge: a counting sort by the
 * lower vertex, then small sorts by the higher one. Linear time for bounded vertex degrees, 24 bytes
 * per triangle and 8 per vertex.
 */
class EdgeUses
{
public:
  explicit EdgeUses(const Surface& surface)
    : starts_(surface.vertices.size() + 2, 0)
    , uses_(3 * surface.triangles.size())
  {
    // Counted two places up, so that filling leaves each start where it belongs.
    for (const Triangle& triangle : surface.triangles)
    {
      for (int i = 0; i < 3; ++i)
      {
        ++starts_[static_cast<std::size_t>(std::min(triangle[i], triangle[(i + 1) % 3])) + 2];
      }
    }
    for (std::size_t v = 2; v < starts_.size(); ++v)
    {
      starts_[v] += starts_[v - 1];
    }
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
      const Triangle& triangle = surface.triangles[t];
      for (int i = 0; i < 3; ++i)
      {
        const std::int32_t from = triangle[i], to = triangle[(i + 1) % 3];
        const std::size_t low = static_cast<std::size_t>(std::min(from, to));
        uses_[starts_[low + 1]++] = {
          std::max(from, to), static_cast<std::uint32_t>(2 * t + (from < to ? 1 : 0))};
      }
    }
  }

  /// Calls visit(low, first, last) for every edge, with its uses in [first, last), in the order of
  /// (low, high); the uses of an edge are in the order of the triangles.
  template <class Visit> void forEachEdge(const Visit& visit)
  {
    for (std::size_t low = 0; low + 2 < starts_.size(); ++low)
    {
      EdgeUse* first = uses_.data() + starts_[low];
      EdgeUse* const end = uses_.data() + starts_[low + 1];
      std::sort(first, end,
        [](const EdgeUse& a, const EdgeUse& b)
        { return a.high != b.high ? a.high < b.high : a.triangleAndSense < b.triangleAndSense; });
      while (first != end)
      {
        const EdgeUse* last = first;
        while (last != end && last->high == first->high)
        {
          ++last;
        }
        visit(static_cast<std::int32_t>(low), const_cast<const EdgeUse*>(first), last);
        first += last - first;
      }
    }
  }

private:
  std::vector<std::size_t> starts_;
  std::vector<EdgeUse> uses_;
};

} // namespace winding
