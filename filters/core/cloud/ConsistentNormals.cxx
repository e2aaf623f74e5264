// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/ConsistentNormals.h"

#include "base/Progress.h"
#include "cloud/CloudNoise.h"
#include "cloud/NoisyNormals.h"
#include "cloud/PlaceNormals.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <memory>

namespace winding
{

namespace
{

OrientedPlaces orientPlaces(
  const DistinctPoints& places, std::size_t neighbors, Normals byTree, Executor& executor)
{
  if (places.size() < 2)
  {
    return {Normals(places.size(), Eigen::Vector3d(0, 0, 1)), 0, false};
  }
  Progress progress(executor);
  progress.set(0, 0.1);
  auto graph = std::make_unique<const NeighborGraph>(places, neighbors, executor);
  const std::vector<double> spacings = spacingsOf(places, *graph);
  const bool hasNoise = isNoisy(places, *graph, spacings, executor);
  progress.set(0.1, 1);
  if (!hasNoise)
  {
    return orientDensely(
      places, std::move(graph), spacings, neighbors, false, std::move(byTree), executor);
  }
  graph.reset();
  return orientNoisy(places, spacings, neighbors, std::move(byTree), executor);
}

} // namespace

ConsistentNormals consistentNormals(const DistinctPoints& places, int neighbors, Executor& executor,
  std::vector<Eigen::Vector3d> byTree)
{
  if (!byTree.empty())
  {
    byTree = normalsByPlace(places, byTree);
  }
  const OrientedPlaces oriented = orientPlaces(
    places, static_cast<std::size_t>(std::max(neighbors, 3)), std::move(byTree), executor);
  ConsistentNormals result;
  result.deviation = oriented.deviation;
  result.triedPatches = oriented.triedPatches;
  result.normals = places.byPoint(oriented.normals);
  return result;
}

std::vector<unsigned char> normalsToTurn(const std::vector<Eigen::Vector3d>& positions,
  const std::vector<Eigen::Vector3d>& normals, Executor& executor)
{
  std::vector<Eigen::Vector3d> usable, directions;
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    const Eigen::Vector3d direction = normals[i].stableNormalized();
    if (positions[i].allFinite() && direction.allFinite() && direction.squaredNorm() > 0)
    {
      usable.push_back(positions[i]);
      directions.push_back(direction);
      numbers.push_back(i);
    }
  }
  ShownExecutor shown(executor);
  Progress progress(shown);
  progress.set(0, 0.05);
  const DistinctPoints places(usable, unitScaleOf(usable), shown);
  progress.set(0.05, 1);
  const OrientedPlaces oriented =
    orientByPatches(places, normalsByPlace(places, directions), true, shown);
  std::vector<unsigned char> turns(positions.size());
  for (std::size_t place = 0; place < places.size(); ++place)
  {
    for (const std::uint32_t* point = places.begin(place); point != places.end(place); ++point)
    {
      turns[numbers[*point]] = directions[*point].dot(oriented.normals[place]) < 0;
    }
  }
  return turns;
}

} // namespace winding
