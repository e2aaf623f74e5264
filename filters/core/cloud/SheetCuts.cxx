#include "cloud/SheetCuts.h"

#include "cloud/NeighborGraph.h"
#include "source/DistinctPoints.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace winding
{

bool cutSheets(const DistinctPoints& places, const std::vector<Eigen::Vector3d>& smooth,
  const std::vector<Eigen::Vector3d>& turned, Executor& executor)
{
  if (places.size() < 2)
  {
    return false;
  }
  constexpr std::size_t neighbors = 6, placesPerBlock = 4096;
  constexpr float mostDoubt = 0.1f; // 26 degrees between normals, or steps 6 out of their planes
  const NeighborGraph graph(places, neighbors, executor);
  const auto normalAt = [&](const std::vector<Eigen::Vector3d>& normals, std::size_t place)
  {
    return normals[*places.begin(place)];
  };
  std::vector<Eigen::Vector3d> normals(places.size());
  for (std::size_t place = 0; place < places.size(); ++place)
  {
    normals[place] = normalAt(smooth, place);
  }
  std::vector<std::size_t> cuts((places.size() + placesPerBlock - 1) / placesPerBlock),
    rounds = cuts;
  runBlocks(
    places.size(), placesPerBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      for (std::size_t place = first; place < last; ++place)
      {
        const Eigen::Vector3d other = normalAt(turned, place);
        rounds[block] += normals[place].dot(other) < 0 ? 1 : 0;
        const bool isCut = std::any_of(graph.begin(place), graph.end(place, neighbors),
          [&](std::size_t neighbor)
          {
            return normals[place].dot(normals[neighbor]) > 0 &&
                   other.dot(normalAt(turned, neighbor)) < 0 &&
                   stepBetween(places, normals, place, neighbor).doubt < mostDoubt;
          });
        cuts[block] += isCut ? 1 : 0;
      }
    },
    executor);
  const auto sumOf = [](const std::vector<std::size_t>& counts)
  {
    return static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::size_t(0)));
  };
  constexpr double leastRim = 1.25;
  const double turnedRound = sumOf(rounds);
  return turnedRound > 0 && sumOf(cuts) >= leastRim * std::sqrt(turnedRound);
}

} // namespace winding
