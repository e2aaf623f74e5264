#include "private/VoxelEvaluation.h"

#include "base/Executor.h"
#include "level/CoverageFractions.h"
#include "level/VoxelOverlap.h"
#include "private/SmpExecutor.h"

#include <algorithm>

namespace winding
{

EvaluationCost VoxelEvaluation::additionalCost(const Field& field, std::size_t voxels) const
{
  switch (coverage)
  {
  case Coverage::any:
    return costOfOverlap(field, voxels);
  case Coverage::fraction:
    return costOfFractions(field, voxels, samplesPerAxis);
  default:
    return {};
  }
}

void VoxelEvaluation::run(
  const Field& field, const Grid& grid, const Extent& extent, SmpExecutor& executor) const
{
  FieldOutput atCenters = output;
  atCenters.inside = coverage == Coverage::fraction ? nullptr : output.inside;
  const bool hasCenters =
    atCenters.values || atCenters.doubleValues || atCenters.inside || atCenters.hasDistances();
  // About what comes after it takes as long, or very much longer.
  const double end = !hasCenters                    ? 0
                     : coverage == Coverage::center ? 1
                     : coverage == Coverage::any    ? 0.5
                                                    : 0.1;
  executor.setShare(0, end);
  if (hasCenters && !field.evaluate(grid, extent, atCenters, executor))
  {
    throw Interrupted();
  }
  if (coverage == Coverage::any)
  {
    executor.setShare(end, 1);
    addOverlap(field, grid, extent, output.rule, output.threshold, output.inside, executor);
  }
  if (coverage == Coverage::fraction)
  {
    this->evaluateFractions(field, grid, extent, end, executor);
  }
}

void VoxelEvaluation::evaluateFractions(const Field& field, const Grid& grid, const Extent& extent,
  double firstProgress, SmpExecutor& executor) const
{
  const CoverageFractions sampling(
    field, grid, extent, samplesPerAxis, output.rule, output.threshold, fractions);
  const auto progressAt = [&](int part)
  {
    return firstProgress + (1 - firstProgress) * part / sampling.parts();
  };
  for (int part = 0; part < sampling.parts(); ++part)
  {
    executor.setShare(progressAt(part), progressAt(part + 1));
    sampling.evaluate(part, executor);
  }
  std::transform(fractions, fractions + sampleCount(extent), output.inside,
    [](float fraction) { return static_cast<unsigned char>(fraction >= 0.5F); });
}

} // namespace winding
