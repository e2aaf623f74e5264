// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "source/PointCloud.h"
#include "source/Surface.h"

/**
 * @file
 * Methods in their simplest form, to measure what better ones gain. referenceSum() of the core is
 * that of the winding number.
 */

/// Whether a ray along +x crosses the surface an odd number of times: one test per triangle, in
/// rounded arithmetic (Möller, Trumbore 1997). Rays through edges and vertices may count twice.
bool naiveParity(const winding::Surface& surface, const Eigen::Vector3d& sample);

/// A cloud of the surface's vertices. Each has the area-weighted mean of its triangles' normals,
/// and a third of their areas.
winding::PointCloud verticesOf(const winding::Surface& surface);
