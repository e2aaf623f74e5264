#pragma once

#include "base/Views.h"

#include <hwy/cache_control.h>

#include <cstddef>
#include <cstdint>

namespace winding
{

/**
 * Asks memory for what belongs to the corners of triangles that come soon, and goes on at once.
 * Points of large meshes lie anywhere: a loop over triangles that waits for each of them takes a
 * third longer.
 *
 * To be called for the triangles of a view in their order; `end` is where the loop ends. Calls
 * ask(id) for the corners of the triangle some places ahead whose ids are valid.
 */
template <class Ask>
void askAhead(const TrianglesView& view, std::size_t triangle, std::size_t end, const Ask& ask)
{
  constexpr std::size_t ahead = 16;
  if (triangle + ahead < end)
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const auto id = static_cast<std::size_t>(view.triangles(triangle + ahead, corner));
      if (id < view.points.size())
      {
        ask(id);
      }
    }
  }
}

/// Asks memory for a point.
inline void askForPoint(const TrianglesView& view, std::size_t id)
{
  hwy::Prefetch(static_cast<const char*>(view.points.address(id)));
}

} // namespace winding
