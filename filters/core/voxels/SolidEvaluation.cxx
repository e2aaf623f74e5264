// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/SolidEvaluation.h"

#include "base/Progress.h"
#include "voxels/LabelMerge.h"

#include <algorithm>

namespace winding
{

namespace
{

constexpr std::size_t mostSamples = 1 << 24;

std::size_t bytesPerSample(const SolidEvaluationOptions& options)
{
  return 1 + (options.withValues ? sizeof(float) : 0) +
         (options.voxels.coverage == Coverage::fraction ? sizeof(float) : 0);
}

} // namespace

double SolidEvaluation::bytes(const SolidEvaluationOptions& options, std::size_t samples)
{
  return static_cast<double>(bytesPerSample(options) * std::min(samples, mostSamples));
}

void SolidEvaluation::reserve(std::size_t samples)
{
  if (samples <= reserved_)
  {
    return;
  }
  // Arrays are not set: evaluation writes all of them, and touching memory takes time.
  reserved_ = samples;
  inside_.reset(new unsigned char[samples]);
  values_.reset(options_.withValues ? new float[samples] : nullptr);
  shares_.reset(options_.voxels.coverage == Coverage::fraction ? new float[samples] : nullptr);
}

/// Finds the part of an extent that holds all voxels that can be inside.
Extent SolidEvaluation::extentOf(const Field& field, const Grid& grid, const Extent& extent) const
{
  const FieldOutput& output = options_.voxels.output;
  const Bounds& bounds = field.info().bounds;
  if (output.isInside(0))
  {
    return extent;
  }
  if (field.info().primitives == 0)
  {
    return {0, -1, 0, -1, 0, -1};
  }
  if (!field.integerRows())
  {
    return extent;
  }
  // A voxel reaches half a spacing beyond its sample, and vertices are rounded.
  constexpr double margin = 1.5;
  Extent near;
  for (int axis = 0; axis < 3; ++axis)
  {
    const IndexRange range = indicesBetween(grid.inGridUnits(bounds.min(), axis) - margin,
      grid.inGridUnits(bounds.max(), axis) + margin, extent[2 * axis], extent[2 * axis + 1]);
    near[2 * axis] = range.first;
    near[2 * axis + 1] = range.second;
  }
  return near;
}

void SolidEvaluation::run(const Field& field, double plate, const Grid& grid, const Extent& extent,
  LabelMerge& merge, SideTally* sides, Executor& executor)
{
  const Extent near = this->extentOf(field, grid, extent);
  if (sampleCount(near) == 0)
  {
    return;
  }
  const Extent layer = {near[0], near[1], near[2], near[3], 0, 0};
  const int layers = static_cast<int>(std::clamp<std::size_t>(
    mostSamples / sampleCount(layer), 1, static_cast<std::size_t>(near[5] - near[4] + 1)));
  Progress progress(executor);
  const double all = near[5] - near[4] + 1;
  for (int k = near[4]; k <= near[5]; k += layers)
  {
    SolidVoxels part;
    part.extent = near;
    part.extent[4] = k;
    part.extent[5] = std::min(near[5], k + layers - 1);
    const std::size_t samples = sampleCount(part.extent);
    VoxelEvaluation voxels = options_.voxels;
    voxels.plate = plate;
    if (voxels.coverage != Coverage::center || plate > 0)
    {
      refuseUnlessFree(static_cast<double>(voxels.additionalBytes(field, samples)),
        options_.freeMemory, "the coverage of " + std::to_string(samples) + " voxels",
        {largerVoxels(), inPieces()});
    }
    this->reserve(samples);
    voxels.output.inside = inside_.get();
    voxels.output.values = values_.get();
    voxels.output.sides = sides;
    voxels.fractions = shares_.get();
    part.inside = inside_.get();
    part.values = values_.get();
    part.shares = shares_.get();
    progress.set((k - near[4]) / all, (part.extent[5] + 1 - near[4]) / all);
    voxels.run(field, grid, part.extent, executor);
    merge.add(part, executor);
  }
}

} // namespace winding
