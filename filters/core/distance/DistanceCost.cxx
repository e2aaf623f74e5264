#include "distance/DistanceCost.h"

#include "distance/DistanceTree.h"

namespace winding
{

EvaluationCost costOfDistances(const SampledSource& source, double band)
{
  const bool areTriangles = source.kind == Primitive::triangle;
  const auto primitives = static_cast<double>(source.primitives);
  const auto samples = static_cast<double>(source.samples);
  EvaluationCost cost;
  cost.bytes = DistanceTree::bytesFor(areTriangles, source.primitives);
  // Every primitive is nearest, or may be, to some of the samples beside it and to some far away;
  // only the former are within a band.
  const double beside = (areTriangles ? 1.8e-6 : 0.4e-6) * primitives + 35e-9 * samples;
  const double within = samples > 0 ? std::min(1.0, 2 * band * source.area / samples) : 0;
  const double away = (areTriangles ? 0.6e-6 : 0.2e-6) * primitives +
                      (areTriangles ? 0.7e-6 : 0.9e-6) * std::sqrt(primitives * samples);
  const bool hasBand = band < std::numeric_limits<double>::infinity();
  cost.seconds = beside + (hasBand ? std::min(1.0, 2 * within) : 1) * away;
  if (!source.isGrid)
  {
    // Cells of scattered samples are larger than those of as many samples of a grid, and have to be
    // sorted. Few samples are searched for one by one, and look at more nodes the farther they are.
    // Measured for 70 000 triangles: 2.3 µs for each of 300 000 random samples, 1.7 of a million.
    const double perSearch = (areTriangles ? 30e-9 : 20e-9) * std::pow(primitives, 0.44);
    cost.seconds =
      0.3e-6 * primitives + std::min(perSearch * samples, 3.3 * cost.seconds + 0.15e-6 * samples);
  }
  return cost;
}

} // namespace winding
