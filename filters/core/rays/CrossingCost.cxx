#include "rays/CrossingCost.h"

namespace winding
{

EvaluationCost costOfRows(const SampledSource& source)
{
  const auto triangles = static_cast<double>(source.primitives);
  const auto samples = static_cast<double>(source.samples);
  // There are as many rows as samples across them; triangles are crossed by rows in proportion to
  // their area. Where they are smaller than voxels, most lie between the rows.
  const double reaching = std::min(triangles, 4 * source.area);
  return {slowdownByCacheMisses(source.primitives) * (35e-9 * triangles + 20e-9 * reaching) +
            20e-9 * std::pow(samples, 2.0 / 3) + 15e-9 * source.area + secondsPerValue * samples,
    (bytesPerPrimitive + 20) * source.primitives};
}

EvaluationCost costOfCrossings(
  std::size_t triangles, std::size_t samples, const RaysThroughTriangles& rays)
{
  // A triangle is tested by the samples within it, and by those in the columns along it: as many as
  // are on a line across all of them, by its sides. Long and narrow triangles are passed over by a
  // binary search on most lines, others are tested on most: measured for walls of thin sheet metal
  // and for scans.
  const auto count = static_cast<double>(samples);
  const double slowdown = slowdownByCacheMisses(triangles);
  const double perSample = 35e-9 + 12.5e-9 * rays.layers;
  return {40e-9 * slowdown * static_cast<double>(triangles) + perSample * count +
            slowdown * (12e-9 * rays.lengths + 90e-9 * rays.widths) * std::sqrt(count),
    (bytesPerPrimitive + 140) * triangles + 42 * samples};
}

} // namespace winding
