// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Views.h"
#include "source/Surface.h"

#include <hwy/cache_control.h>

#include <cstddef>
#include <cstdint>
#include <vector>

/**
 * @file
 * Loops over triangles ask memory for what belongs to the corners of triangles that come soon, and
 * go on at once. Points of large meshes lie anywhere: a loop that waits for each of them takes a
 * third longer.
 */
namespace winding
{

/// The number of triangles between the one that a loop works on and the one it asks for.
constexpr std::size_t trianglesAhead = 16;

/**
 * To be called for the triangles of a view in their order; `end` is where the loop ends. Calls
 * ask(id) for the corners of the triangle some places ahead whose ids are valid.
 */
template <class Ask>
void prefetch(const TrianglesView& view, std::size_t triangle, std::size_t end, const Ask& ask)
{
  if (triangle + trianglesAhead < end)
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const auto id = static_cast<std::size_t>(view.triangles(triangle + trianglesAhead, corner));
      if (id < view.points.size())
      {
        ask(id);
      }
    }
  }
}

/// Asks memory for the items of the corners of a triangle some places behind one. To be called for
/// triangles in their order; all ids are valid.
template <class Item>
void prefetchCorners(const Item* items, const TriangleList& triangles, std::size_t triangle)
{
  if (triangle + trianglesAhead < triangles.size())
  {
    for (const std::int32_t id : triangles[triangle + trianglesAhead])
    {
      hwy::Prefetch(&items[static_cast<std::size_t>(id)]);
    }
  }
}

/// Asks memory for a point.
inline void askForPoint(const TrianglesView& view, std::size_t id)
{
  hwy::Prefetch(static_cast<const char*>(view.points.address(id)));
}

} // namespace winding
