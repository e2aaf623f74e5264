// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "source/SourceVolume.h"

#include "source/CoordinateOrder.h"

#include <algorithm>
#include <cmath>

namespace winding
{

namespace
{

/// The size of a sum that does not depend on the order of what is added.
double sizeOfSum(std::vector<double>& terms)
{
  std::sort(terms.begin(), terms.end());
  double sum = 0;
  for (const double term : terms)
  {
    sum += term;
  }
  return std::abs(sum);
}

} // namespace

double volumeOf(const Surface& surface)
{
  if (surface.bounds.isEmpty())
  {
    return 0;
  }
  const Eigen::Vector3d middle = surface.bounds.center();
  std::vector<double> terms;
  terms.reserve(surface.triangles.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    const Triangle t = lowestFirst(surface.vertices, surface.triangles[i]);
    const Eigen::Vector3d& a = surface.vertices[t[0]];
    const Eigen::Vector3d u = surface.vertices[t[1]] - a, v = surface.vertices[t[2]] - a;
    terms.push_back((a - middle).dot(u.cross(v)) / 6);
  }
  return sizeOfSum(terms);
}

double volumeOf(const PointCloud& cloud)
{
  if (cloud.bounds.isEmpty())
  {
    return 0;
  }
  const Eigen::Vector3d middle = cloud.bounds.center();
  std::vector<double> terms;
  terms.reserve(cloud.positions.size());
  for (std::size_t i = 0; i < cloud.positions.size(); ++i)
  {
    terms.push_back((cloud.positions[i] - middle).dot(cloud.normals[i]) * cloud.areas[i] / 3);
  }
  return sizeOfSum(terms);
}

} // namespace winding
