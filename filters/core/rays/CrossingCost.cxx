#include "rays/CrossingCost.h"

#include <cmath>

namespace winding
{

EvaluationCost costOfRows(std::size_t triangles, std::size_t samples)
{
  const auto count = static_cast<double>(triangles);
  return {150e-9 * count + secondsPerValue * static_cast<double>(samples),
    (bytesPerPrimitive + 20) * triangles};
}

EvaluationCost costOfCrossings(
  std::size_t triangles, std::size_t samples, const RaysThroughTriangles& rays)
{
  // A triangle is tested by the samples within it, and by those in the columns along it: as many as
  // are on a line across all of them, by its width.
  const auto count = static_cast<double>(samples);
  const double perSample = 60e-9 + 15e-9 * rays.layers;
  return {150e-9 * static_cast<double>(triangles) + perSample * count +
            80e-9 * rays.widths * std::sqrt(count),
    (bytesPerPrimitive + 140) * triangles + 42 * samples};
}

} // namespace winding
