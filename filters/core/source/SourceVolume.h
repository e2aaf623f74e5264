// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "source/PointCloud.h"
#include "source/Surface.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace winding
{

///@{
/**
 * The size of the volume that a source encloses, in cubes of its coordinates' unit: that of the
 * cones from the middle of its bounds to its triangles, or to its points with their areas, which
 * must be there. It is the solid's for a closed surface (divergence theorem), and about that
 * for surfaces with small holes and for clouds. Components that are oriented inward count as
 * cavities.
 *
 * The bits depend on the set of the triangles or points only, not on their order. Takes
 * O(n log n) time and 8 bytes for each.
 */
double volumeOf(const Surface& surface);
double volumeOf(const PointCloud& cloud);
///@}

/// Returns volumeOf() each of `count` parts of a surface; `partOf` has the part of each triangle.
std::vector<double> volumesOf(
  const Surface& surface, const std::vector<std::int32_t>& partOf, std::size_t count);

} // namespace winding
