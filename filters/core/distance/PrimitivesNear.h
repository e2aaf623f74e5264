// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "source/PointCloud.h"
#include "source/Surface.h"

#include <cstddef>

namespace winding
{

///@{
/**
 * The number of triangles of a surface, or of points of a cloud, that are no farther from a sample
 * than a distance. Distances are exact up to rounding, as in NearestKernels.h.
 *
 * The primitives are looked at one after the other, in linear time: a few samples are not worth a
 * DistanceTree.
 */
std::size_t trianglesNear(const Surface& surface, const Eigen::Vector3d& sample, double distance);
std::size_t pointsNear(const PointCloud& cloud, const Eigen::Vector3d& sample, double distance);
///@}

} // namespace winding
