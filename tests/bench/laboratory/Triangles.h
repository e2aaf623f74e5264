// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Views.h"

#include <cstdint>
#include <vector>

/// Coordinates and triangles of a mesh in double precision, as the core's views take them.
struct Triangles
{
  std::vector<double> coordinates; ///< x y z of each point
  std::vector<std::int64_t> ids;   ///< three points of each triangle

  std::size_t points() const { return coordinates.size() / 3; }
  std::size_t triangles() const { return ids.size() / 3; }

  /// A view of these arrays, which must not change while it is used.
  winding::TrianglesView view() const
  {
    return {{coordinates.data(), this->points()}, {ids.data(), this->triangles()}};
  }
};
