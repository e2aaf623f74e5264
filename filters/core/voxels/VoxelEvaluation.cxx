// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/VoxelEvaluation.h"

#include "base/Progress.h"
#include "voxels/CoverageFractions.h"
#include "voxels/VoxelOverlap.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace winding
{

std::size_t VoxelEvaluation::additionalBytes(const Field& field, std::size_t voxels) const
{
  if (plate > 0)
  {
    return field.expectedBytesOfDistances(voxels) + sizeof(float) * voxels;
  }
  switch (coverage)
  {
  case Coverage::any:
    return bytesOfOverlap(field, voxels);
  case Coverage::fraction:
    return bytesOfFractions(field, voxels, samplesPerAxis);
  case Coverage::center:
    break;
  }
  return 0;
}

void VoxelEvaluation::run(
  const Field& field, const Grid& grid, const Extent& extent, Executor& executor) const
{
  if (plate > 0)
  {
    this->evaluatePlate(field, grid, extent, executor);
    return;
  }
  Progress progress(executor);
  FieldOutput atCenters = output;
  atCenters.inside = coverage == Coverage::fraction ? nullptr : output.inside;
  const bool hasCenters = atCenters.values || atCenters.doubleValues || atCenters.inside ||
                          atCenters.hasDistances() || atCenters.sides;
  // About what comes after it takes as long, or very much longer.
  const double end = !hasCenters                    ? 0
                     : coverage == Coverage::center ? 1
                     : coverage == Coverage::any    ? 0.5
                                                    : 0.1;
  progress.set(0, end);
  if (hasCenters)
  {
    field.evaluate(grid, extent, atCenters, executor);
  }
  if (coverage == Coverage::any)
  {
    progress.set(end, 1);
    addOverlap(field, grid, extent, output.isInside, output.inside, executor);
  }
  if (coverage == Coverage::fraction)
  {
    progress.set(end, 1);
    this->evaluateFractions(field, grid, extent, executor);
  }
}

/// Finds the part of each voxel in a plate as if that were at right angles to an axis. Values and
/// distances are the field's.
void VoxelEvaluation::evaluatePlate(
  const Field& field, const Grid& grid, const Extent& extent, Executor& executor) const
{
  FieldOutput ofField = output;
  std::vector<float> distances(output.distances ? 0 : sampleCount(extent));
  ofField.inside = nullptr;
  ofField.distances = output.distances ? output.distances : distances.data();
  field.evaluate(grid, extent, ofField, executor);
  const double voxel = grid.spacing.maxCoeff();
  for (std::size_t i = 0; i < sampleCount(extent); ++i)
  {
    const double depth = 0.5 * plate - std::abs(static_cast<double>(ofField.distances[i]));
    const double share = std::clamp(depth / voxel + 0.5, 0.0, 1.0);
    if (output.inside)
    {
      output.inside[i] = static_cast<unsigned char>(depth >= 0);
    }
    if (fractions)
    {
      fractions[i] = static_cast<float>(share);
    }
  }
}

void VoxelEvaluation::evaluateFractions(
  const Field& field, const Grid& grid, const Extent& extent, Executor& executor) const
{
  Progress progress(executor);
  const CoverageFractions sampling(
    field, grid, extent, samplesPerAxis, output.isInside, fractions, united);
  const double parts = sampling.parts();
  for (int part = 0; part < sampling.parts(); ++part)
  {
    progress.set(part / parts, (part + 1) / parts);
    sampling.evaluate(part, executor);
  }
  std::transform(fractions, fractions + sampleCount(extent), output.inside,
    [](float fraction) { return static_cast<unsigned char>(fraction >= 0.5F); });
}

} // namespace winding
