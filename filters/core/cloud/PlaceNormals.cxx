// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/PlaceNormals.h"

#include "base/Progress.h"
#include "cloud/CloudNoise.h"
#include "cloud/NormalEstimation.h"
#include "cloud/NormalTrials.h"
#include "source/CompareCoordinates.h"

#include <algorithm>
#include <utility>

namespace winding
{

namespace
{

/// The deviation of clouds whose normals are right is mostly less than this: 0.001 to 0.01 of clean
/// ones, and 0.013 to 0.021 of noisy ones up to scale, where wrong ones have 0.025 and more.
/// It is more where solids overlap, for w is 3/2 on the parts within others. Clouds beyond it are
/// oriented by patches, too, which costs them time only.
constexpr double smallDeviation = 0.02;

} // namespace

OrientedPlaces orientDensely(const DistinctPoints& places,
  std::unique_ptr<const NeighborGraph> graph, const std::vector<double>& spacings,
  std::size_t neighbors, bool isNoisy, Normals byTree, Executor& executor)
{
  constexpr double spreadOfNoise = 3;
  Progress progress(executor);
  const PlacesField field(places, spacings, isNoisy ? spreadOfNoise : 1, executor);
  if (byTree.empty())
  {
    progress.set(0, 0.02);
    byTree = planeNormals(places, *graph, neighbors, executor);
    progress.set(0.02, 0.05);
    orientByTree(places, *graph, byTree, executor);
  }
  progress.set(0.05, 0.1);
  // Noise makes all areas too large. Without a factor for that, normals that cancel each other fit
  // better than right ones: the noisy gantry of clouds.md had 0.795 in common with its solid in the
  // mean of nine draws, and 0.811 with it.
  BestNormals best(
    std::make_shared<const Normals>(std::move(byTree)), isNoisy ? deviationUpToScale : deviationOf);
  tryAsTheyAre(best.normals, field, best);
  const std::size_t between = (fewNeighbors + neighbors) / 2;
  if (best.deviation < smallDeviation)
  {
    if (!isNoisy)
    {
      progress.set(0.1, 1);
      trySheets(places, *graph, {between, neighbors}, field, executor, best);
    }
    return {turned(*best.normals, best.turns), best.deviation, false};
  }
  // Small planes separate the sheets of thin parts, and large ones see through noise, and across
  // sheets that are closer than the points.
  std::vector<std::size_t> sizes = {neighbors, 2 * neighbors};
  if (!isNoisy)
  {
    sizes.insert(sizes.begin(), {fewNeighbors, between});
  }
  // Gradients of points that are spread far take long, when single points are turned.
  const double endOfSizes = isNoisy ? 0.3 : 0.9;
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    const double ofSize = (endOfSizes - 0.1) / static_cast<double>(sizes.size());
    const double begin = 0.1 + ofSize * static_cast<double>(i);
    progress.set(begin, begin + ofSize / 10);
    const auto normals =
      std::make_shared<const Normals>(planeNormals(places, *graph, sizes[i], executor));
    progress.set(begin + ofSize / 10, begin + ofSize);
    tryPatches(places, *graph, normals, field, executor, best);
  }
  if (!isNoisy)
  {
    trySheets(places, *graph, {between, neighbors}, field, executor, best);
  }
  graph.reset();
  progress.set(endOfSizes, 1);
  turnSinglePoints(places, field, executor, best);
  return {turned(*best.normals, best.turns), best.deviation, true};
}

Normals normalsByPlace(const DistinctPoints& places, const Normals& normals)
{
  Normals byPlace(places.size());
  for (std::size_t place = 0; place < places.size(); ++place)
  {
    byPlace[place] = normals[*std::min_element(places.begin(place), places.end(place),
      [&](std::uint32_t a, std::uint32_t b)
      { return compareCoordinates(normals[a], normals[b]) < 0; })];
  }
  return byPlace;
}

OrientedPlaces orientByPatches(
  const DistinctPoints& places, Normals normals, bool turnsSinglePoints, Executor& executor)
{
  constexpr std::size_t neighbors = 10;
  if (places.size() < 2)
  {
    return {std::move(normals), 0, false};
  }
  Progress progress(executor);
  const auto given = std::make_shared<const Normals>(std::move(normals));
  BestNormals best(given);
  progress.set(0, 0.15);
  const NeighborGraph graph(places, neighbors, executor);
  const std::vector<double> spacings = spacingsOf(places, graph);
  const PlacesField field(places, spacings, 1, executor);
  progress.set(0.15, 0.2);
  tryAsTheyAre(given, field, best);
  const bool triesPatches = best.deviation >= smallDeviation;
  if (triesPatches)
  {
    Normals byTree = *given;
    progress.set(0.2, 0.35);
    orientByTree(places, graph, byTree, executor);
    progress.set(0.35, 0.4);
    tryAsTheyAre(std::make_shared<const Normals>(std::move(byTree)), field, best);
    progress.set(0.4, turnsSinglePoints ? 0.8 : 1);
    tryPatches(places, graph, given, field, executor, best);
    if (turnsSinglePoints)
    {
      progress.set(0.8, 1);
      turnSinglePoints(places, field, executor, best);
    }
  }
  return {turned(*best.normals, best.turns), best.deviation, triesPatches};
}

} // namespace winding
