// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/Shapes.h"

#include <vector>

namespace shapes
{

/// A solid of unit cubes, as it is or sheared and turned, with samples on its quarter lattice: a
/// ray along x from any of them runs along faces, edges or through vertices, or is in general
/// position.
struct LatticeSolid
{
  Mesh mesh;
  std::vector<Point> samples;
  std::vector<double> windings; ///< winding numbers of the samples

  /// Whether a sample is not on the surface.
  bool isOff(std::size_t sample) const { return windings[sample] == 0 || windings[sample] == 1; }
};

inline std::vector<LatticeSolid> latticeSolids(unsigned seed)
{
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d sheared = (Eigen::Matrix3d() << 1, 2, 1, 0, 1, 1, 0, 0, 1).finished();
  const Eigen::Matrix3d turned = (Eigen::Matrix3d() << 1, -1, 1, 1, 1, 0, -1, 2, 3).finished();
  std::vector<LatticeSolid> solids;
  for (const Cells& cells : {lShape(), randomCells(4, seed)})
  {
    for (const Eigen::Matrix3d& matrix : {identity, sheared, turned})
    {
      LatticeSolid solid;
      solid.mesh = surfaceOf(cells).mapped([&](const Point& p) -> Point { return matrix * p; });
      for (int n = 0; n < 21 * 21 * 21; ++n)
      {
        const Point p = 0.25 * Point(n % 21 - 2, n / 21 % 21 - 2, n / 441 - 2);
        solid.samples.push_back(matrix * p);
        solid.windings.push_back(windingOf(cells, p));
      }
      solids.push_back(solid);
    }
  }
  return solids;
}

} // namespace shapes
