// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "source/SourceVolume.h"

#include "source/CoordinateOrder.h"

#include <algorithm>
#include <cmath>
#include <iterator>

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

/// Returns the volume of the cone from `apex` to a triangle.
double coneVolume(const Surface& surface, std::size_t triangle, const Eigen::Vector3d& apex)
{
  const Triangle t = lowestFirst(surface.vertices, surface.triangles[triangle]);
  const Eigen::Vector3d& a = surface.vertices[t[0]];
  const Eigen::Vector3d u = surface.vertices[t[1]] - a, v = surface.vertices[t[2]] - a;
  return (a - apex).dot(u.cross(v)) / 6;
}

} // namespace

double volumeOf(const Surface& surface)
{
  return volumesOf(surface, std::vector<std::int32_t>(surface.triangles.size()), 1)[0];
}

std::vector<double> volumesOf(
  const Surface& surface, const std::vector<std::int32_t>& partOf, std::size_t count)
{
  std::vector<std::vector<double>> terms(count);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    terms[partOf[i]].push_back(coneVolume(surface, i, surface.bounds.center()));
  }
  std::vector<double> volumes;
  std::transform(terms.begin(), terms.end(), std::back_inserter(volumes), sizeOfSum);
  return volumes;
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
