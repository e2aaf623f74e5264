// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/UsesByAngle.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace winding
{

std::vector<AngledUse> usesByAngle(
  const Surface& surface, const SurfaceEdges& edges, const SurfaceEdges::Crowd& crowd)
{
  const Eigen::Vector3d& low = surface.vertices[crowd.low];
  const Eigen::Vector3d along = (surface.vertices[crowd.high] - low).stableNormalized();
  const Eigen::Vector3d across = along.unitOrthogonal(), up = along.cross(across);
  std::vector<AngledUse> uses;
  for (const SurfaceEdges::Use* use = edges.begin(crowd); use != edges.end(crowd); ++use)
  {
    Eigen::Vector3d to = Eigen::Vector3d::Zero();
    for (const std::int32_t vertex : surface.triangles[use->triangle])
    {
      if (vertex != crowd.low && vertex != crowd.high)
      {
        to = (surface.vertices[vertex] - low).stableNormalized();
      }
    }
    const double x = to.dot(across), y = to.dot(up);
    uses.push_back({std::atan2(y, x), std::hypot(x, y) > leastAngle, *use});
  }
  std::sort(uses.begin(), uses.end(),
    [](const AngledUse& a, const AngledUse& b)
    { return a.angle < b.angle || (a.angle == b.angle && a.use.triangle < b.use.triangle); });
  return uses;
}

} // namespace winding
