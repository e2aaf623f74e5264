// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/NoisyNormals.h"

#include "base/Progress.h"
#include "cloud/CloudNoise.h"
#include "cloud/NoisySheets.h"
#include "cloud/NormalTrials.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace winding
{

namespace
{

/// Thins a noisy cloud so far that noise is no more than about half a spacing.
std::vector<Eigen::Vector3d> thinned(const DistinctPoints& places, double noise)
{
  constexpr double wanted = 0.6;
  const double ratio = noise / wanted;
  const std::size_t step =
    std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(std::min(ratio * ratio, 64.0))));
  std::vector<Eigen::Vector3d> some;
  some.reserve(places.size() / step + 1);
  for (std::size_t place = step / 2; place < places.size(); place += step)
  {
    some.push_back(places.positions()[place]);
  }
  return some;
}

/// Orients a noisy cloud by some of its places, where noise is small compared with its parts.
OrientedPlaces orientThinned(const DistinctPoints& places, const std::vector<double>& spacings,
  std::size_t neighbors, Normals byTree, Executor& executor)
{
  Progress progress(executor);
  progress.set(0, 0.1);
  PlacePlanes planes = placePlanes(places, 2 * neighbors, executor);
  std::vector<Eigen::Vector3d> some =
    thinned(places, quantileInSpacings(std::move(planes.deviations), spacings, 0.5));
  constexpr std::size_t enough = 1000;
  if (some.size() == places.size() || some.size() < enough)
  {
    planes.normals = Normals();
    progress.set(0.1, 0.2);
    auto graph = std::make_unique<const NeighborGraph>(places, 2 * neighbors, executor);
    progress.set(0.2, 1);
    return orientDensely(
      places, std::move(graph), spacings, neighbors, true, std::move(byTree), executor);
  }
  byTree = Normals();
  progress.set(0.1, 0.15);
  const DistinctPoints sparse(some, 1, executor);
  some = std::vector<Eigen::Vector3d>();
  auto graph = std::make_unique<const NeighborGraph>(sparse, 2 * neighbors, executor);
  const std::vector<double> wide = spacingsOf(sparse, *graph);
  const bool isStillNoisy = isNoisy(sparse, *graph, wide, executor);
  progress.set(0.15, 0.75);
  const OrientedPlaces oriented =
    orientDensely(sparse, std::move(graph), wide, neighbors, isStillNoisy, {}, executor);
  progress.set(0.75, 1);
  constexpr double spread = 2;
  const PlacesField field(sparse, wide, spread, executor);
  const Turns turns = turnsUphill(
    field.gradients(oriented.normals, Turns(sparse.size(), 0), places.positions()), planes.normals);
  return {turned(std::move(planes.normals), turns), oriented.deviation, oriented.triedPatches};
}

/// The normals of noisy sheets that are close to each other: senses are found by the places moved
/// onto their sheets, which separates them, and directions are smoothed along them. There are none
/// where sheets do not come apart: then w of the moved places deviates by 0.22 and more, else by
/// less than 0.07, measured.
Normals normalsOfSheets(const DistinctPoints& places, const std::vector<double>& spacings,
  std::size_t neighbors, Executor& executor)
{
  constexpr int rounds = 3;
  constexpr double hopeless = 0.15;
  Progress progress(executor);
  progress.set(0, 0.35);
  Normals normals;
  {
    SheetPlanes planes = sheetPlanes(places, NeighborGraph(places, 2 * neighbors, executor),
      spacings, {fewNeighbors, neighbors, 2 * neighbors}, executor);
    const DistinctPoints feet(planes.feet, unitScaleOf(planes.feet), executor);
    planes.feet = Normals();
    Normals ofFeet = normalsByPlace(feet, planes.normals);
    planes.normals = Normals();
    progress.set(0.35, 0.7);
    const OrientedPlaces oriented = orientByPatches(feet, std::move(ofFeet), false, executor);
    if (oriented.deviation > hopeless)
    {
      return {};
    }
    normals = feet.byPoint(oriented.normals);
  }
  progress.set(0.7, 1);
  const NeighborGraph graph(places, 2 * neighbors, executor);
  for (int round = 0; round < rounds; ++round)
  {
    normals = smoothedAlongSheets(places, graph, spacings, normals, executor);
  }
  return normals;
}

/// Orients a noisy cloud in several ways and takes the one that fits best.
OrientedPlaces orientInTheBestWay(const DistinctPoints& places, const std::vector<double>& spacings,
  std::size_t neighbors, Normals byTree, Executor& executor)
{
  constexpr double spread = 3, good = 0.035, farBetter = 0.6;
  Progress progress(executor);
  progress.set(0, 0.4);
  OrientedPlaces best = orientThinned(places, spacings, neighbors, std::move(byTree), executor);
  if (!best.triedPatches)
  {
    return best;
  }
  const PlacesField field(places, spacings, spread, executor);
  const Turns none(places.size(), 0);
  double least = deviationUpToScale(field.valuesOf(best.normals, none));
  if (least < good)
  {
    return best;
  }
  const auto take = [&](Normals normals)
  {
    const double deviation = deviationUpToScale(field.valuesOf(normals, none));
    if (deviation < farBetter * least)
    {
      best.normals = std::move(normals);
      best.deviation = least = deviation;
    }
  };
  progress.set(0.4, 0.75);
  Normals ofSheets = normalsOfSheets(places, spacings, neighbors, executor);
  if (!ofSheets.empty())
  {
    take(std::move(ofSheets));
  }
  if (least >= good)
  {
    progress.set(0.75, 0.8);
    Normals ofParts = planeNormals(places, 3 * neighbors, executor);
    progress.set(0.8, 1);
    take(orientByPatches(places, std::move(ofParts), false, executor).normals);
  }
  return best;
}

/// Finds senses and directions once more, where most senses are right. Senses have come from fields
/// that are spread over three spacings and more, which mix the sides of thin parts; one that is
/// spread over half as much separates more of them: it added 0.006 to what the noisy gantry of
/// clouds.md has in common with its solid. Directions have come from planes through neighbours of
/// all sheets; planes of twice as many neighbours on one sheet only added 0.003, and 0.008 for
/// bones.
Normals foundAgain(const DistinctPoints& places, const std::vector<double>& spacings,
  std::size_t neighbors, Normals normals, Executor& executor)
{
  constexpr double spread = 1;
  Progress progress(executor);
  progress.set(0, 0.6);
  {
    const PlacesField field(places, spacings, spread, executor);
    const Turns turns =
      turnsUphill(field.gradients(normals, Turns(places.size(), 0), places.positions()), normals);
    normals = turned(std::move(normals), turns);
  }
  progress.set(0.6, 1);
  const NeighborGraph graph(places, 2 * neighbors, executor);
  return sheetNormals(places, graph, normals, 2 * neighbors, executor);
}

} // namespace

OrientedPlaces orientNoisy(const DistinctPoints& places, const std::vector<double>& spacings,
  std::size_t neighbors, Normals byTree, Executor& executor)
{
  Progress progress(executor);
  progress.set(0, 0.9);
  OrientedPlaces oriented =
    orientInTheBestWay(places, spacings, neighbors, std::move(byTree), executor);
  progress.set(0.9, 1);
  oriented.normals = foundAgain(places, spacings, neighbors, std::move(oriented.normals), executor);
  return oriented;
}

} // namespace winding
