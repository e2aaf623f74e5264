// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "source/SourceArea.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace winding
{

namespace
{

/// The area of every `step`-th triangle.
double areaOfEvery(
  std::size_t step, const std::vector<Eigen::Vector3d>& vertices, const TriangleList& triangles)
{
  double twice = 0;
  for (std::size_t i = 0; i < triangles.size(); i += step)
  {
    const Triangle& triangle = triangles[i];
    const Eigen::Vector3d& a = vertices[triangle[0]];
    twice += (vertices[triangle[1]] - a).cross(vertices[triangle[2]] - a).stableNorm();
  }
  return twice / 2;
}

} // namespace

double areaOf(const std::vector<Eigen::Vector3d>& vertices, const TriangleList& triangles)
{
  return areaOfEvery(1, vertices, triangles);
}

double approximateAreaOf(
  const std::vector<Eigen::Vector3d>& vertices, const TriangleList& triangles)
{
  constexpr std::size_t enough = 65536;
  // An odd step meets all kinds of triangles also where pairs or fours of them alternate.
  const std::size_t step = triangles.size() < 2 * enough ? 1 : (triangles.size() / enough - 1) | 1;
  const double area = areaOfEvery(step, vertices, triangles);
  const auto seen = static_cast<double>((triangles.size() + step - 1) / step);
  return step == 1 ? area : area / seen * static_cast<double>(triangles.size());
}

std::function<Eigen::Vector3d(double u, double v, double t)> pointOnTriangles(
  const std::vector<Eigen::Vector3d>& vertices, const TriangleList& triangles)
{
  std::vector<double> cumulativeAreas;
  cumulativeAreas.reserve(triangles.size());
  double area = 0;
  for (const Triangle& t : triangles)
  {
    const Eigen::Vector3d& a = vertices[t[0]];
    area += (vertices[t[1]] - a).cross(vertices[t[2]] - a).stableNorm();
    cumulativeAreas.push_back(area);
  }
  return [&vertices, &triangles, areas = std::move(cumulativeAreas)](double u, double v, double t)
  {
    const auto found = std::upper_bound(areas.begin(), areas.end(), t * areas.back());
    const std::size_t i =
      std::min<std::size_t>(static_cast<std::size_t>(found - areas.begin()), triangles.size() - 1);
    const Triangle& triangle = triangles[i];
    const double root = std::sqrt(u);
    return Eigen::Vector3d((1 - root) * vertices[triangle[0]] +
                           root * (1 - v) * vertices[triangle[1]] +
                           root * v * vertices[triangle[2]]);
  };
}

double distanceBetweenSamples(const Bounds& bounds, std::size_t samples)
{
  if (bounds.isEmpty() || samples == 0)
  {
    return 0;
  }
  const Eigen::Array3d sizes = bounds.sizes().array() + 0.1 * bounds.sizes().maxCoeff();
  return std::cbrt(sizes[0]) * std::cbrt(sizes[1]) * std::cbrt(sizes[2]) /
         std::cbrt(static_cast<double>(samples));
}

} // namespace winding
