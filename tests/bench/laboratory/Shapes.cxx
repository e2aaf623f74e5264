// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "laboratory/Shapes.h"

#include <Eigen/Core>

#include <cmath>
#include <numeric>
#include <utility>

Triangles lumpySphere(int n)
{
  const double pi = std::acos(-1.0);
  const auto point = [&](int i, int j) -> Eigen::Vector3d
  {
    const double theta = pi * i / n, phi = 2 * pi * (j % n) / n;
    const double r = 1 + 0.2 * std::sin(5 * theta) * std::cos(4 * phi);
    return {r * std::sin(theta) * std::cos(phi), r * std::sin(theta) * std::sin(phi),
      r * std::cos(theta)};
  };
  Triangles sphere;
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      for (const auto& [di, dj] : {std::pair(0, 0), {1, 0}, {0, 1}, {0, 1}, {1, 0}, {1, 1}})
      {
        const Eigen::Vector3d corner = point(i + di, j + dj);
        sphere.coordinates.insert(sphere.coordinates.end(), corner.data(), corner.data() + 3);
      }
    }
  }
  sphere.ids.resize(sphere.points());
  std::iota(sphere.ids.begin(), sphere.ids.end(), 0);
  return sphere;
}

winding::Surface withHoles(const winding::Surface& surface, std::size_t period)
{
  winding::Surface result = surface;
  result.triangles.clear();
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
  {
    if (i % period != 0)
    {
      result.triangles.push_back(surface.triangles[i]);
    }
  }
  return result;
}
