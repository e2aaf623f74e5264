// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "source/Surface.h"

#include <cstddef>
#include <vector>

namespace winding
{

/**
 * Counts pairs of triangles where an edge of one passes through the other. Triangles that
 * share two vertices are no pair; of two that share one, only the edges opposite to it are
 * looked at.
 *
 * Decisions are exact, up to triangles that touch each other without passing through: those pairs
 * may or may not count. Triangles in one plane never count.
 *
 * Time: linear in the triangles, if these are of about one size and not crowded. Memory: about 100
 * bytes for each triangle. Throws Interrupted.
 */
std::size_t countSelfIntersections(
  const std::vector<Eigen::Vector3d>& vertices, const TriangleList& triangles, Executor& executor);

} // namespace winding
