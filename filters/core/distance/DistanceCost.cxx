#include "distance/DistanceCost.h"

#include "distance/DistanceTree.h"
#include "distance/PlaceBuckets.h"

#include <algorithm>
#include <cmath>

namespace winding
{

EvaluationCost costOfDistances(const SampledSource& source, double band)
{
  const bool areTriangles = source.kind == Primitive::triangle;
  const auto primitives = static_cast<double>(source.primitives);
  const auto samples = static_cast<double>(source.samples);
  EvaluationCost cost;
  cost.bytes = DistanceTree::bytesFor(areTriangles, source.primitives);
  // Every primitive is nearest, or may be, to some of the nearby samples and to some far away;
  // only the former are within a band. The lists of samples that lie close together get no shorter
  // than for one sample, which are longer for more primitives, and for samples farther away.
  const double beside = (areTriangles ? 1.5e-6 : 0.4e-6) * primitives + 14e-9 * samples;
  const double within = samples > 0 ? std::min(1.0, 2 * band * source.area / samples) : 0;
  const double far = std::min(1.0, samples / (40 * std::max(source.area, 1.0)));
  // In a flat box, of a plate, say, no sample is far away. The volume over the area, as a part
  // of the box's size, is 0.4 to 0.9 for scans, and 0.15 for thin sheet metal. Areas that overlap
  // may look like a plate, too, so that it counts within bounds only.
  const double depth = std::cbrt(samples) * std::cbrt(samples) / std::max(source.area, 1e-300);
  const double flatness = std::pow(std::clamp(depth / 0.4, 0.25, 1.0), 0.7);
  const double away =
    flatness * ((areTriangles ? 0.4e-6 : 0.13e-6) * primitives +
                 (areTriangles ? 0.6e-6 : 0.33e-6) * std::sqrt(primitives * samples) +
                 (areTriangles ? 5.5e-9 : 0) * std::pow(primitives, 0.25) * far * samples);
  const bool hasBand = band < std::numeric_limits<double>::infinity();
  cost.seconds = beside + (hasBand ? std::min(1.0, 2 * within) : 1) * away;
  if (source.isGrid)
  {
    return cost;
  }
  cost.bytes += sizeof(Place) * source.samples;
  // Samples that are searched for one by one look at more nodes the farther they are: 3 µs of one
  // thread for each among 70 000 triangles, 8 among 560 000, 15 among 5.5 million (measured). Cells
  // of scattered samples are larger than those of as many samples of a grid, and have to be sorted;
  // where there are about as many samples as primitives, they take about as long as searches.
  const double perSearch = (areTriangles ? 130e-9 : 40e-9) * std::pow(primitives, 0.3);
  const double searches = 0.4e-6 * primitives + flatness * perSearch * samples;
  const double cells =
    0.3e-6 * primitives + (areTriangles ? 2 : 1.2) * cost.seconds + 0.15e-6 * samples;
  cost.seconds = source.samples < source.primitives ? searches : std::min(searches, cells);
  return cost;
}

} // namespace winding
