// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/VoxelTreesMemory.h"

#include "level/CubeRanges.h"
#include "level/LevelMemory.h"

#include <algorithm>
#include <cmath>

namespace winding
{

namespace
{

/// The cubes that the surface divides.
double cubesAtSurface(
  const Field& field, const Grid& grid, const Bricks& bricks, const VoxelTreeOptions& options)
{
  const double edges = levelEdgesByArea(field, grid);
  // A voxel's share that is inside tells of a surface anywhere in it, and one that only touches a
  // voxel changes its side but not the value at its centre.
  const bool tellsWholeVoxels = options.withCoverage || (!options.byCenters && options.withValues);
  double cubes = 0;
  for (int level = 1; level <= bricks.depth; ++level)
  {
    const double side = std::ldexp(1, level);
    cubes += edges * (tellsWholeVoxels ? side : side - 1) / (side * side * side);
  }
  return cubes;
}

/// The cubes that the end of the grid divides.
double cubesAtEnd(const Grid& grid, const Bricks& bricks)
{
  double cubes = 0;
  for (int level = 1; level <= bricks.depth; ++level)
  {
    const Eigen::Array3i side = Eigen::Array3i::Constant(1 << level);
    const Eigen::Array3d whole = (grid.dimensions.array() / side).cast<double>();
    const Eigen::Array3d all = ((grid.dimensions.array() - 1) / side + 1).cast<double>();
    cubes += all.prod() - whole.prod();
  }
  return cubes;
}

/// A grid whose voxels are cubes of 2^level voxels, so that it has at most 64 along each axis.
Grid coarseGrid(const Grid& grid, int& level)
{
  constexpr int mostSamples = 64;
  for (level = 0; (grid.dimensions.maxCoeff() - 1) >> level >= mostSamples;)
  {
    ++level;
  }
  Grid coarse;
  coarse.spacing = std::ldexp(1, level) * grid.spacing;
  coarse.firstSample = grid.corner() + 0.5 * coarse.spacing;
  coarse.dimensions = ((grid.dimensions.array() - 1) / (1 << level) + 1).matrix();
  return coarse;
}

/// The cubes in which w varies by more than the tolerance, though no surface passes through them.
double cubesOfSmoothField(
  const Field& field, const Grid& grid, const VoxelTreeOptions& options, Executor& executor)
{
  int level;
  const Grid coarse = coarseGrid(grid, level);
  const Extent extent = coarse.wholeExtent();
  std::vector<float> values(sampleCount(extent));
  FieldOutput output;
  output.values = values.data();
  field.evaluate(coarse, extent, output, executor);
  const CubeRanges<float> ranges(values.data(), extent, extent);
  const Eigen::Vector3i counts = coarse.dimensions / 2;
  constexpr double leastJump = 0.3; // w changes by 1 at a triangle, and by less between samples
  double cubes = 0;
  for (int k = 0; k < counts[2]; ++k)
  {
    for (int j = 0; j < counts[1]; ++j)
    {
      for (int i = 0; i < counts[0]; ++i)
      {
        const auto range = ranges[{1, {i, j, k}}];
        const double difference =
          static_cast<double>(range.largest) - static_cast<double>(range.least);
        // Between the two samples of the coarse grid along an axis lie 2^level steps of the grid,
        // and between the first and the last voxel of a cube of it one less than it has voxels.
        double parts = 1;
        for (int n = level + 1; n > 0 && difference < leastJump; --n)
        {
          const double variation = difference * (std::ldexp(1, n) - 1) / std::ldexp(1, level);
          cubes += variation > options.tolerance ? parts : 0;
          parts *= 8;
        }
      }
    }
  }
  return cubes;
}

} // namespace

double expectedVertices(
  const Field& field, const Grid& grid, const VoxelTreeOptions& options, Executor& executor)
{
  const Bricks bricks = bricksOf(grid);
  const auto roots = static_cast<double>(bricks.size());
  const double most = roots * std::ldexp(8.0 / 7, 3 * bricks.depth);
  const bool mayVary = options.withValues && !field.integerRows();
  if (mayVary && options.tolerance == 0)
  {
    return most;
  }
  const double cubes = cubesAtSurface(field, grid, bricks, options) + cubesAtEnd(grid, bricks) +
                       (mayVary ? cubesOfSmoothField(field, grid, options, executor) : 0);
  return std::min(most, roots + 8 * cubes);
}

std::size_t bytesOfVoxelTrees(
  const Field& field, const Grid& grid, const VoxelTreeOptions& options, double vertices)
{
  // A vertex has its numbers and a bit of the mask; the children of a parent, and of its
  // neighbors, have a number of 4 bytes.
  const double bytesPerVertex = 1 + 2.5 + (options.withValues ? (options.asDouble ? 8 : 4) : 0) +
                                (options.withCoverage ? sizeof(float) : 0);
  constexpr double bytesPerTree = 500;
  const double bytes = vertices * bytesPerVertex +
                       bytesPerTree * static_cast<double>(bricksOf(grid).size()) +
                       VoxelTrees::bytesAtWork(field, grid, options);
  return static_cast<std::size_t>(std::min(bytes, 1e18));
}

} // namespace winding
