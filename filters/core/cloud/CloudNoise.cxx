#include "cloud/CloudNoise.h"

#include "base/Pi.h"

#include <algorithm>
#include <cmath>

namespace winding
{

namespace
{

/// The quantile of some values, which it moves.
double quantile(std::vector<double>& values, double share)
{
  const auto at =
    values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The deviations of points from the planes of their neighbourhoods, in spacings.
std::vector<double> deviationsOf(const DistinctPoints& places, const NeighborGraph& graph,
  const std::vector<double>& spacings, std::size_t neighbors, Executor& executor)
{
  std::vector<double> deviations = planeDeviations(places, graph, neighbors, executor);
  for (std::size_t place = 0; place < places.size(); ++place)
  {
    deviations[place] /= spacings[place];
  }
  return deviations;
}

} // namespace

std::vector<double> spacingsOf(const DistinctPoints& places, const NeighborGraph& graph)
{
  std::vector<double> spacings(places.size());
  for (std::size_t place = 0; place < places.size(); ++place)
  {
    const std::uint32_t* const end = graph.end(place, fewNeighbors);
    const auto neighbors = static_cast<double>(end - graph.begin(place));
    const Eigen::Vector3d farthest = places.positions()[*(end - 1)] - places.positions()[place];
    // Squares of the distances between places may underflow.
    const double radius = farthest.norm() > 0 ? farthest.norm() : farthest.stableNorm();
    spacings[place] = radius * std::sqrt(pi / neighbors);
  }
  return spacings;
}

bool isNoisy(const DistinctPoints& places, const NeighborGraph& graph,
  const std::vector<double>& spacings, Executor& executor)
{
  constexpr double clean = 0.2;
  std::vector<double> deviations = deviationsOf(places, graph, spacings, fewNeighbors, executor);
  return quantile(deviations, 0.25) > clean;
}

double medianDeviation(const DistinctPoints& places, const NeighborGraph& graph,
  const std::vector<double>& spacings, std::size_t neighbors, Executor& executor)
{
  std::vector<double> deviations = deviationsOf(places, graph, spacings, neighbors, executor);
  return quantile(deviations, 0.5);
}

} // namespace winding
