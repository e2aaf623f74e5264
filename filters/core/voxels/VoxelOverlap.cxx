// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/VoxelOverlap.h"

#include "source/PointCloud.h"
#include "source/Surface.h"
#include "voxels/TouchedVoxels.h"

namespace winding
{

namespace
{

bool changesAtTrianglesOnly(const FieldInfo& info)
{
  return info.isSurface && info.netBoundaryEdges == 0;
}

/// Adds the voxels that have a corner inside. Neighbours share corners, so the corners are a grid
/// of their own.
void addCorners(const Field& field, const Grid& grid, const Extent& extent,
  const InsideTest& isInside, unsigned char* inside, Executor& executor)
{
  const Grid cornerGrid = {grid.corner(), grid.spacing, grid.dimensions + Eigen::Vector3i::Ones()};
  const Extent cornerExtent = {
    extent[0], extent[1] + 1, extent[2], extent[3] + 1, extent[4], extent[5] + 1};
  std::vector<unsigned char> corners(sampleCount(cornerExtent));
  FieldOutput output;
  output.inside = corners.data();
  output.isInside = isInside;
  field.evaluate(cornerGrid, cornerExtent, output, executor);
  const auto width = static_cast<std::size_t>(extent[1] - extent[0] + 1);
  runBlocks(
    static_cast<std::size_t>(extent[5] - extent[4] + 1), 1,
    [&](std::size_t layer, std::size_t, std::size_t)
    {
      const int k = extent[4] + static_cast<int>(layer);
      for (int j = extent[2]; j <= extent[3]; ++j)
      {
        unsigned char* const row = inside + sampleNumber(extent, extent[0], j, k);
        for (const auto& [dj, dk] :
          {std::pair(0, 0), std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)})
        {
          const unsigned char* const from =
            &corners[sampleNumber(cornerExtent, extent[0], j + dj, k + dk)];
          for (std::size_t i = 0; i < width; ++i)
          {
            row[i] |= static_cast<unsigned char>(from[i] | from[i + 1]);
          }
        }
      }
    },
    executor);
}

} // namespace

void addOverlap(const Field& field, const Grid& grid, const Extent& extent,
  const InsideTest& isInside, unsigned char* inside, Executor& executor)
{
  if (sampleCount(extent) == 0)
  {
    return;
  }
  if (!changesAtTrianglesOnly(field.info()))
  {
    addCorners(field, grid, extent, isInside, inside, executor);
  }
  if (const Surface* surface = field.distinctSurface())
  {
    markTouched(*surface, grid, extent, inside, executor);
  }
  if (const PointCloud* cloud = field.cloud())
  {
    markTouched(*cloud, grid, extent, inside, executor);
  }
}

std::size_t bytesOfOverlap(const Field& field, std::size_t samples)
{
  constexpr std::size_t bytesPerMark = 32;
  return (changesAtTrianglesOnly(field.info()) ? 0 : samples) +
         bytesPerMark * field.info().distinct;
}

} // namespace winding
