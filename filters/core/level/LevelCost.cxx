#include "level/LevelCost.h"

#include "level/LevelEdges.h"
#include "sums/DirectSumCost.h"

#include <algorithm>

namespace winding
{

namespace
{

/// The most memory at a time for each edge: itself, its crossings or its search, its vertex and the
/// triangles around that. Measured at 512 and 1000 voxels along bunny_70k, maxplanck_open_90k and
/// kitten_points_normals: 160, 275 and 200.
double bytesPerEdge(const Field& field)
{
  if (field.info().jumpsOnly())
  {
    return 160;
  }
  return field.info().isSurface ? 275 : 200;
}

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
  if (field.info().jumpsOnly())
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

} // namespace

double levelEdgesByArea(const Field& field, const Grid& grid)
{
  const Eigen::Vector3d& h = grid.spacing;
  const double perArea = 0.5 / h[0] / h[1] + 0.5 / h[0] / h[2] + 0.5 / h[1] / h[2];
  const double all = 3.0 * grid.dimensions.cast<double>().prod();
  return std::min(all, field.area() * perArea);
}

double levelEdgesByCoarseGrid(const Field& field, const Grid& grid, InsideRule rule,
  double threshold, bool withBorder, Executor& executor)
{
  constexpr int mostSamples = 64;
  Grid coarse = grid;
  Eigen::Vector3d factors;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int factor = (grid.dimensions[axis] - 1) / mostSamples + 1;
    factors[axis] = factor;
    coarse.dimensions[axis] = (grid.dimensions[axis] - 1) / factor + 1;
    coarse.spacing[axis] = factor * grid.spacing[axis];
  }
  LevelEdges edges(field, coarse, rule, threshold, withBorder);
  while (!edges.isDone())
  {
    edges.advance(executor);
  }
  double count = 0;
  for (std::size_t n = 0; n < edges.size(); ++n)
  {
    // One edge of the coarse grid stands for the edges of all rows next to it.
    count += factors.prod() / factors[edges[n].axis];
  }
  return count;
}

EvaluationCost costOfLevelSurface(const Field& field, const Grid& grid, double edges)
{
  const double bytes = std::min(edges * bytesPerEdge(field), 1e18);
  return {
    secondsOfLevelSurface(field, sampleCount(grid.wholeExtent())), static_cast<std::size_t>(bytes)};
}

} // namespace winding
