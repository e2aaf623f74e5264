// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "distance/PrimitivesNear.h"

#include "distance/NearestKernels.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <limits>

namespace winding
{

namespace
{

/// Whether a triangle's box is near. Most boxes are not, and spare the triangle's distance.
bool isBoxNear(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
  const Eigen::Vector3d& sample, double distance)
{
  const auto isNearAlong = [&](int axis)
  {
    return std::min({a[axis], b[axis], c[axis]}) - sample[axis] <= distance &&
           sample[axis] - std::max({a[axis], b[axis], c[axis]}) <= distance;
  };
  return isNearAlong(0) && isNearAlong(1) && isNearAlong(2);
}

} // namespace

std::size_t trianglesNear(const Surface& surface, const Eigen::Vector3d& sample, double distance)
{
  const double scale = unitScale(surface.bounds);
  const Eigen::Vector3d at = sample * scale;
  const double limit = distance * scale;
  std::size_t count = 0;
  for (const Triangle& ids : surface.triangles)
  {
    const Eigen::Vector3d &a = surface.vertices[ids[0]], &b = surface.vertices[ids[1]],
                          &c = surface.vertices[ids[2]];
    if (isBoxNear(a, b, c, sample, distance))
    {
      const NearTriangle triangle = nearTriangle(a * scale, b * scale, c * scale);
      Nearest nearest = {std::numeric_limits<double>::infinity(), {0, 0, 0}};
      findNearest(&triangle, {0, 1}, at.data(), nearest);
      count += nearest.squared <= limit * limit;
    }
  }
  return count;
}

std::size_t pointsNear(const PointCloud& cloud, const Eigen::Vector3d& sample, double distance)
{
  const double scale = unitScale(cloud.bounds);
  const auto isNear = [&](const Eigen::Vector3d& position)
  {
    return ((position - sample) * scale).norm() <= distance * scale;
  };
  return static_cast<std::size_t>(
    std::count_if(cloud.positions.begin(), cloud.positions.end(), isNear));
}

} // namespace winding
