// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/AutomaticNormals.h"

#include "base/Progress.h"
#include "cloud/CloudNoise.h"
#include "cloud/ConsistentNormals.h"
#include "cloud/NormalTrials.h"
#include "cloud/OverlappingNormals.h"
#include "cloud/PlaceNormals.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace winding
{

namespace
{

/// The share of places with solids around them, below which they say nothing.
constexpr double fewWithinSolids = 0.02;

/// Some of the places of a noisy cloud, moved onto their planes.
struct CalmPlaces
{
  std::vector<std::uint32_t> from; ///< the places that have been moved
  Normals feet;                    ///< where they are now
  Normals planes;                  ///< the normals of all places' planes, in either sense
};

/// Returns places that are as far apart as the noise is small, moved onto planes.
CalmPlaces calmPlaces(const DistinctPoints& places, std::size_t neighbors, Executor& executor)
{
  constexpr double wanted = 0.45; // noise in spacings, before places are moved
  const NeighborGraph graph(places, neighbors, executor);
  PlacePlanes planes = placePlanes(places, neighbors, executor);
  const double ratio =
    quantileInSpacings(std::move(planes.deviations), spacingsOf(places, graph), 0.5) / wanted;
  const auto step = static_cast<std::size_t>(std::lround(std::clamp(ratio * ratio, 1.0, 64.0)));
  CalmPlaces calm;
  for (std::size_t place = step / 2; place < places.size(); place += step)
  {
    const Eigen::Vector3d& position = places.positions()[place];
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    const std::uint32_t* const end = graph.end(place, neighbors);
    for (const std::uint32_t* to = graph.begin(place); to != end; ++to)
    {
      sum += places.positions()[*to] - position;
    }
    const Eigen::Vector3d& normal = planes.normals[place];
    const auto points = static_cast<double>(end - graph.begin(place) + 1);
    calm.from.push_back(static_cast<std::uint32_t>(place));
    calm.feet.emplace_back(position + normal.dot(sum) / points * normal);
  }
  calm.planes = std::move(planes.normals);
  return calm;
}

/// Returns the normals of some places.
Normals chosen(const Normals& normals, const std::vector<std::uint32_t>& from)
{
  Normals some;
  for (const std::uint32_t place : from)
  {
    some.push_back(normals[place]);
  }
  return some;
}

/// Returns the normals of a cloud without noise, by point. The graph is given up where it is needed
/// no more.
Normals normalsOfClean(const DistinctPoints& places, std::unique_ptr<const NeighborGraph> graph,
  Normals byTree, int neighbors, Executor& executor)
{
  Progress progress(executor);
  progress.set(0, 0.1);
  const std::size_t count = graph->neighborsPerPlace();
  OverlappingNormals::Found overlapping =
    OverlappingNormals(places, *graph, executor).improved(normalsByPlace(places, byTree));
  graph.reset();
  if (areFarMore(overlapping.faultsByParity, overlapping.faults))
  {
    return places.byPoint(overlapping.normals);
  }
  progress.set(0.1, 0.97);
  Normals consistent = consistentNormals(places, neighbors, executor, std::move(byTree)).normals;
  if (overlapping.withinSolids < fewWithinSolids)
  {
    return consistent;
  }
  progress.set(0.97, 1);
  const NeighborGraph again(places, count, executor);
  const double faults =
    OverlappingNormals(places, again, executor).faultsOf(normalsByPlace(places, consistent));
  return areFarMore(faults, overlapping.faults) ? places.byPoint(overlapping.normals) : consistent;
}

/// Returns the normals of a noisy cloud, by point.
Normals normalsOfNoisy(
  const DistinctPoints& places, Normals byTree, int neighbors, Executor& executor)
{
  constexpr std::size_t enough = 1000;
  constexpr double spread = 2;
  const auto count = static_cast<std::size_t>(neighbors);
  Progress progress(executor);
  progress.set(0, 0.05);
  const CalmPlaces calm = calmPlaces(places, 2 * count, executor);
  const DistinctPoints feet(calm.feet, unitScaleOf(calm.feet), executor);
  const auto consistentOnes = [&]
  {
    progress.set(0.1, 0.95);
    return consistentNormals(places, neighbors, executor, std::move(byTree)).normals;
  };
  if (feet.size() < enough)
  {
    return consistentOnes();
  }
  const NeighborGraph graph(feet, count, executor);
  const std::vector<double> spacings = spacingsOf(feet, graph);
  if (isNoisy(feet, graph, spacings, executor))
  {
    return consistentOnes();
  }
  const auto atFeet = [&](const Normals& normals)
  {
    return normalsByPlace(feet, chosen(normalsByPlace(places, normals), calm.from));
  };
  const auto everywhere = [&](const Normals& normals)
  {
    const PlacesField field(feet, spacings, spread, executor);
    const Turns none(feet.size(), 0);
    return places.byPoint(turned(
      calm.planes, turnsUphill(field.gradients(normals, none, places.positions()), calm.planes)));
  };
  progress.set(0.05, 0.1);
  const OverlappingNormals overlapping(feet, graph, executor);
  const OverlappingNormals::Found found = overlapping.improved(atFeet(byTree));
  if (areFarMore(found.faultsByParity, found.faults))
  {
    return everywhere(found.normals);
  }
  const Normals consistent = consistentOnes();
  // Single normals that are wrong say little here, so patches are compared.
  const bool isOverlapping =
    found.withinSolids >= fewWithinSolids &&
    areFarMore(overlapping.improved(atFeet(consistent)).faults, found.faults);
  return isOverlapping ? everywhere(found.normals) : consistent;
}

} // namespace

Normals automaticNormals(
  const DistinctPoints& places, Normals byTree, int neighbors, Executor& executor)
{
  const int count = std::max(neighbors, 3);
  Progress progress(executor);
  progress.set(0, 0.03);
  auto graph =
    std::make_unique<const NeighborGraph>(places, static_cast<std::size_t>(count), executor);
  const bool isClean = !isNoisy(places, *graph, spacingsOf(places, *graph), executor);
  progress.set(0.03, 1);
  if (isClean)
  {
    return normalsOfClean(places, std::move(graph), std::move(byTree), count, executor);
  }
  graph.reset();
  return normalsOfNoisy(places, std::move(byTree), count, executor);
}

} // namespace winding
