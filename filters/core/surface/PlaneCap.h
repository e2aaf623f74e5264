// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "source/Surface.h"

#include <cstdint>
#include <vector>

namespace winding
{

/// Closed walks along vertices.
using Rims = std::vector<std::vector<std::int32_t>>;

/**
 * Makes the triangles that rims in a plane go round, seen from where they run counter-clockwise:
 * their boundary is the rims, whatever these are. Rims that do not cross are triangulated as
 * polygons with holes, so that no triangle lies outside of them (ears are cut off, and bridges join
 * holes to what is around them: Eberly, Triangulation by Ear Clipping). Takes O(n²) time.
 *
 * `normal` is the unit normal of the plane. The rims together may run either way round it.
 */
TriangleList planeCapOf(
  const Rims& rims, const std::vector<Eigen::Vector3d>& vertices, const Eigen::Vector3d& normal);

} // namespace winding
