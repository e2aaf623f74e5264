// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/CloudNoise.h"

#include "base/Pi.h"

#include <algorithm>
#include <cmath>

namespace winding
{

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

double quantileInSpacings(
  std::vector<double> deviations, const std::vector<double>& spacings, double share)
{
  for (std::size_t place = 0; place < deviations.size(); ++place)
  {
    deviations[place] /= spacings[place];
  }
  const double before = share * static_cast<double>(deviations.size() - 1);
  const auto at = deviations.begin() + static_cast<std::ptrdiff_t>(before);
  std::nth_element(deviations.begin(), at, deviations.end());
  return *at;
}

bool isNoisy(const DistinctPoints& places, const NeighborGraph& graph,
  const std::vector<double>& spacings, Executor& executor)
{
  constexpr double clean = 0.2;
  return quantileInSpacings(
           planeDeviations(places, graph, fewNeighbors, executor), spacings, 0.25) > clean;
}

} // namespace winding
