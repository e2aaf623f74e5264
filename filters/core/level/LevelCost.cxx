#include "level/LevelCost.h"

#include "sums/DirectSumCost.h"

namespace winding
{

double secondsOfLevelSurface(const Field& field, std::size_t samples)
{
  const SampledSource source = field.sampledSource(samples);
  const auto primitives = static_cast<double>(source.primitives);
  const bool isTriangle = source.kind == Primitive::triangle;
  // The edges that the surface crosses are about as many as its area has squares, or half as many
  // again. Where a source is closed, the triangles that cross them are looked for.
  const double crossings =
    (isTriangle ? 160e-9 * slowdownByCacheMisses(source.primitives) * primitives : 0) +
    0.35e-6 * source.area;
  if (field.integerRows())
  {
    return crossings - secondsPerValue * static_cast<double>(samples); // no values are written
  }
  if (isTriangle && field.info().netBoundaryEdges == 0)
  {
    return crossings;
  }
  // Elsewhere roots are searched for in rounds of scattered samples. Each round has a tree of its
  // own triangles, which are cut for its samples; points have had theirs.
  const double edges = 1.5 * source.area;
  if (field.info().method == Method::direct || field.info().method == Method::parity)
  {
    constexpr double rounds = 3;
    SampledSource ends = source;
    ends.samples = static_cast<std::size_t>(edges);
    return crossings + rounds * costOfDirectSum(ends).seconds;
  }
  return crossings + (isTriangle ? 3e-6 : 1.2e-6) * primitives + (isTriangle ? 2e-6 : 3e-6) * edges;
}

} // namespace winding
