// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/VoxelEvaluation.h"

#include "base/Progress.h"
#include "voxels/CoverageFractions.h"
#include "voxels/VoxelOverlap.h"

#include <algorithm>

namespace winding
{

std::size_t VoxelEvaluation::additionalBytes(const Field& field, std::size_t voxels) const
{
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
