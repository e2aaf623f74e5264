// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "source/Surface.h"

#include <cstddef>
#include <vector>

namespace winding
{

/// A surface with its vertices and triangles in an order that follows from coordinates alone.
/// Decisions about it depend on the set of its triangles, whatever order they came in.
struct CanonicalOrder
{
  Surface surface;
  PolygonParts parts;
  std::vector<std::size_t> numbers; ///< by triangle: its index in the given surface

  /// Returns flags by triangle of `surface` as flags by triangle of the given one.
  std::vector<char> given(const std::vector<char>& flags) const
  {
    std::vector<char> result(flags.size());
    for (std::size_t i = 0; i < flags.size(); ++i)
    {
      result[numbers[i]] = flags[i];
    }
    return result;
  }
};

/// Returns a surface in canonical order: its polygons by their lowest triangles, and the triangles
/// of each polygon as they were. Triangles that are no parts of polygons begin at their lowest
/// corners. No two vertices may be equal. Takes O(n log n) time.
CanonicalOrder inCanonicalOrder(const Surface& surface, const PolygonParts& parts);

} // namespace winding
