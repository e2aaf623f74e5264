#pragma once

#include "source/PointCloud.h"
#include "source/Surface.h"

#include <cstddef>

namespace winding
{

///@{
/**
 * How many triangles of a surface, or points of a cloud, are no farther from a sample than a distance.
 * Distances are exact up to rounding, that of NearestKernels.h.
 *
 * Time: linear in the primitives, which are looked at one after the other: for a few samples, which are
 * not worth a DistanceTree.
 */
std::size_t trianglesNear(const Surface& surface, const Eigen::Vector3d& sample, double distance);
std::size_t pointsNear(const PointCloud& cloud, const Eigen::Vector3d& sample, double distance);
///@}

} // namespace winding
