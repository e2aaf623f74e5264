// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "laboratory/NaiveSums.h"

#include "base/Executor.h"
#include "source/MeshVertices.h"

#include <utility>

winding::PointCloud verticesOf(const winding::Surface& surface)
{
  winding::PointCloud cloud;
  cloud.positions = surface.vertices;
  const std::size_t points = surface.vertices.size();
  if (points == 0)
  {
    return cloud;
  }
  winding::SerialExecutor serial;
  const winding::MeshVertices vertices =
    winding::meshVertices({{{surface.vertices[0].data(), points},
                            {surface.triangles[0].data(), surface.triangles.size()}}},
      points, serial);
  for (std::size_t i = 0; i < points; ++i)
  {
    cloud.normals.push_back(vertices.normals()[i].stableNormalized());
    cloud.areas.push_back(vertices.areas()[i]);
  }
  cloud.bounds = surface.bounds;
  cloud.inputPoints = points;
  return cloud;
}
