// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/NormalEstimation.h"

#include "base/Progress.h"
#include "cloud/NeighborGraph.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <cmath>
#include <numeric>
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

/// Hands on orientations from places that are finished to their neighbours.
class OrientationTree
{
public:
  OrientationTree(const DistinctPoints& places, const NeighborGraph& graph,
    std::vector<Eigen::Vector3d>& normals, Executor& executor)
    : places_(places)
    , graph_(graph)
    , back_(mutual(graph, places.size()))
    , normals_(normals)
    , progress_(executor)
    , isDone_(places.size())
  {
  }

  bool isDone(std::uint32_t place) const { return isDone_[place] != 0; }

  /// Keeps the normal of a place, and adds the steps from there.
  void finish(std::uint32_t place)
  {
    isDone_[place] = 1;
    progress_.step(++finished_, places_.size());
    const auto add = [this, place](std::uint32_t other)
    {
      if (!isDone_[other])
      {
        steps_.push(stepBetween(places_, normals_, place, other));
      }
    };
    std::for_each(graph_.begin(place), graph_.end(place, mostSteps), add);
    std::for_each(back_[place].begin(), back_[place].end(), add);
  }

  /// Goes all steps, the surest first.
  void spread()
  {
    while (!steps_.empty())
    {
      const NeighborStep step = steps_.top();
      steps_.pop();
      if (!isDone_[step.to])
      {
        normals_[step.to] *= normals_[step.from].dot(normals_[step.to]) < 0 ? -1 : 1;
        this->finish(step.to);
      }
    }
  }

private:
  const DistinctPoints& places_;
  const NeighborGraph& graph_;
  const std::vector<std::vector<std::uint32_t>> back_;
  std::vector<Eigen::Vector3d>& normals_;
  Progress progress_;
  std::vector<unsigned char> isDone_;
  std::priority_queue<NeighborStep> steps_;
  std::size_t finished_ = 0;
};

/// The places by their heights, the highest first.
template <class Height>
std::vector<std::uint32_t> placesFromHighest(std::size_t places, const Height& heightOf)
{
  std::vector<std::uint32_t> order(places);
  std::iota(order.begin(), order.end(), std::uint32_t(0));
  std::sort(order.begin(), order.end(),
    [&heightOf](std::uint32_t a, std::uint32_t b)
    {
      const double ha = heightOf(a), hb = heightOf(b);
      return ha > hb || (ha == hb && a < b);
    });
  return order;
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
  case NormalEstimation::toward:
    return "viewpoint";
  }
  return "";
}

void orientByTree(const DistinctPoints& places, const NeighborGraph& graph,
  std::vector<Eigen::Vector3d>& normals, Executor& executor)
{
  // Starts go from the top down, so that a piece begins at its highest place.
  const std::vector<std::uint32_t> starts = placesFromHighest(
    places.size(), [&places](std::uint32_t place) { return places.positions()[place][2]; });
  OrientationTree tree(places, graph, normals, executor);
  for (const std::uint32_t start : starts)
  {
    if (!tree.isDone(start))
    {
      normals[start] *= normals[start][2] < 0 ? -1 : 1;
      tree.finish(start);
      tree.spread();
    }
  }
}

void orientFrom(const DistinctPoints& places, const NeighborGraph& graph,
  const std::vector<double>& clearness, double enough, std::vector<Eigen::Vector3d>& normals,
  Executor& executor)
{
  OrientationTree tree(places, graph, normals, executor);
  const std::vector<std::uint32_t> starts = placesFromHighest(
    places.size(), [&clearness](std::uint32_t place) { return clearness[place]; });
  for (const std::uint32_t start : starts)
  {
    const bool isClear = clearness[start] >= enough;
    if (!isClear)
    {
      tree.spread(); // from all that are clear, or from one that is not
    }
    if (!tree.isDone(start))
    {
      tree.finish(start);
    }
  }
  tree.spread();
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
