#include "cloud/NormalEstimation.h"

#include "base/Progress.h"
#include "cloud/NeighborGraph.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace winding
{

namespace
{

/// Steps go to the nearest neighbours only: farther ones help to find the plane, but are not next
/// to a place.
constexpr std::size_t mostSteps = 10;

/// Finds, for each place, the places that it is a neighbour of but that are none of its own
/// neighbours. They make neighbourhood mutual: a far place may be no other's neighbour, though it
/// has neighbours itself.
std::vector<std::vector<std::uint32_t>> mutual(const NeighborGraph& graph, std::size_t places)
{
  std::vector<std::vector<std::uint32_t>> back(places);
  for (std::size_t place = 0; place < places; ++place)
  {
    for (const std::uint32_t* other = graph.begin(place); other != graph.end(place, mostSteps);
         ++other)
    {
      if (std::find(graph.begin(*other), graph.end(*other, mostSteps), place) ==
          graph.end(*other, mostSteps))
      {
        back[*other].push_back(static_cast<std::uint32_t>(place));
      }
    }
  }
  return back;
}

} // namespace

const char* nameOf(NormalEstimation estimation)
{
  switch (estimation)
  {
  case NormalEstimation::automatic:
    return "automatic";
  case NormalEstimation::spanningTree:
    return "spanning tree";
  case NormalEstimation::consistent:
    return "winding consistent";
  }
  return "";
}

void orientByTree(const DistinctPoints& places, const NeighborGraph& graph,
  std::vector<Eigen::Vector3d>& normals, Executor& executor)
{
  const auto back = mutual(graph, places.size());
  // Starts go from the top down, so that a piece begins at its highest place.
  std::vector<std::uint32_t> starts(places.size());
  for (std::size_t i = 0; i < starts.size(); ++i)
  {
    starts[i] = static_cast<std::uint32_t>(i);
  }
  std::sort(starts.begin(), starts.end(),
    [&](std::uint32_t a, std::uint32_t b)
    {
      const double za = places.positions()[a][2], zb = places.positions()[b][2];
      return za > zb || (za == zb && a < b);
    });
  std::vector<unsigned char> isDone(places.size());
  std::priority_queue<NeighborStep> steps;
  Progress progress(executor);
  std::size_t finished = 0;
  const auto finish = [&](std::uint32_t place)
  {
    isDone[place] = 1;
    progress.step(++finished, places.size());
    const auto add = [&](std::uint32_t other)
    {
      if (!isDone[other])
      {
        steps.push(stepBetween(places, normals, place, other));
      }
    };
    std::for_each(graph.begin(place), graph.end(place, mostSteps), add);
    std::for_each(back[place].begin(), back[place].end(), add);
  };
  for (const std::uint32_t start : starts)
  {
    if (isDone[start])
    {
      continue;
    }
    normals[start] *= normals[start][2] < 0 ? -1 : 1;
    finish(start);
    while (!steps.empty())
    {
      const NeighborStep step = steps.top();
      steps.pop();
      if (!isDone[step.to])
      {
        normals[step.to] *= normals[step.from].dot(normals[step.to]) < 0 ? -1 : 1;
        finish(step.to);
      }
    }
  }
}

std::vector<Eigen::Vector3d> estimateNormals(
  const DistinctPoints& places, int neighbors, Executor& executor)
{
  Progress progress(executor);
  std::vector<Eigen::Vector3d> ofPlaces(places.size(), Eigen::Vector3d(0, 0, 1));
  if (places.size() > 1)
  {
    const auto count = static_cast<std::size_t>(std::max(neighbors, 3));
    progress.set(0, 0.5);
    const NeighborGraph graph(places, count, executor);
    progress.set(0.5, 0.6);
    ofPlaces = planeNormals(places, graph, count, executor);
    progress.set(0.6, 1);
    orientByTree(places, graph, ofPlaces, executor);
  }
  return places.byPoint(ofPlaces);
}

} // namespace winding
