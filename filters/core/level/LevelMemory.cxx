// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/LevelMemory.h"

#include "level/LevelEdges.h"

#include <algorithm>

namespace winding
{

namespace
{

/// The memory for each edge that whole rows, or results that are there, have given.
constexpr double bytesPerKnownEdge = 160;

/// Returns the most memory at a time for each edge: itself, its crossings or its search, its vertex
/// and the triangles around that. Measured at 512 and 1000 voxels along bunny_70k,
/// maxplanck_open_90k and kitten_points_normals.
double bytesPerEdge(const Field& field)
{
  if (field.info().jumpsOnly())
  {
    return bytesPerKnownEdge;
  }
  return field.info().isSurface ? 275 : 200;
}

/// Returns a number of bytes that may be more than numbers of bytes can be.
std::size_t inBytes(double bytes)
{
  return static_cast<std::size_t>(std::min(bytes, 1e18));
}

} // namespace

double levelEdgesByArea(const Field& field, const Grid& grid)
{
  const Eigen::Vector3d& h = grid.spacing;
  const double perArea = 0.5 / h[0] / h[1] + 0.5 / h[0] / h[2] + 0.5 / h[1] / h[2];
  const double all = 3.0 * grid.dimensions.cast<double>().prod();
  return std::min(all, field.area() * perArea);
}

double levelEdgesByCoarseGrid(const Field& field, const Grid& grid, const InsideTest& isInside,
  bool withBorder, Executor& executor)
{
  constexpr int mostSamples = 64;
  Grid coarse = grid;
  Eigen::Vector3d factors;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int factor = (grid.dimensions[axis] - 1) / mostSamples + 1;
    factors[axis] = factor;
    coarse.dimensions[axis] = (grid.dimensions[axis] - 1) / factor + 1;
    coarse.spacing[axis] = factor * grid.spacing[axis];
  }
  LevelEdges edges(field, coarse, isInside, withBorder);
  while (!edges.isDone())
  {
    edges.advance(executor);
  }
  double count = 0;
  for (std::size_t n = 0; n < edges.size(); ++n)
  {
    // One edge of the coarse grid stands for the edges of all rows next to it.
    count += factors.prod() / factors[edges[n].axis];
  }
  return count;
}

std::size_t bytesOfCombinedSurface(const Grid& grid, double edges)
{
  return inBytes(LevelEdges::bytesOfRows(grid) + bytesPerKnownEdge * edges);
}

std::size_t bytesOfLevelSurface(const Field& field, double edges)
{
  return inBytes(edges * bytesPerEdge(field));
}

} // namespace winding
