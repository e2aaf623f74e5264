#include "source/SourceArea.h"

#include <cmath>

namespace winding
{

double areaOf(const std::vector<Eigen::Vector3d>& vertices, const std::vector<Triangle>& triangles)
{
  double twice = 0;
  for (const Triangle& triangle : triangles)
  {
    const Eigen::Vector3d& a = vertices[triangle[0]];
    twice += (vertices[triangle[1]] - a).cross(vertices[triangle[2]] - a).stableNorm();
  }
  return twice / 2;
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
