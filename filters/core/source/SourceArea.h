// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "source/Surface.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace winding
{

/// The sum of the areas of triangles, in squares of their coordinates' unit.
double areaOf(const std::vector<Eigen::Vector3d>& vertices, const TriangleList& triangles);

/// About areaOf(), for what only needs its size: of more than 65536 triangles every so manieth is
/// looked at, 65536 of them at least. The order of the triangles decides which.
double approximateAreaOf(
  const std::vector<Eigen::Vector3d>& vertices, const TriangleList& triangles);

/**
 * A function that gives points of triangles, evenly distributed if its arguments are so over
 * [0, 1). It takes linear time to make, keeps references, and its points for given arguments depend
 * on the order of the triangles. There must be triangles.
 */
std::function<Eigen::Vector3d(double u, double v, double t)> pointOnTriangles(
  const std::vector<Eigen::Vector3d>& vertices, const TriangleList& triangles);

/// The distance between samples, if `samples` of them are spread evenly over a box that is larger
/// than the bounds by a twentieth of the longest side on each side, as grids usually are. 0 if
/// there is none.
double distanceBetweenSamples(const Bounds& bounds, std::size_t samples);

} // namespace winding
