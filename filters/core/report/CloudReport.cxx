// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/CloudReport.h"

#include "cloud/NeighborSearch.h"
#include "cloud/OutwardNormals.h"
#include "cloud/PointAreas.h"
#include "source/DistinctPoints.h"
#include "source/PointCloud.h"
#include "source/Sanitize.h"
#include "source/UnitNormal.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace winding
{

namespace
{

/// The finite points of a cloud.
struct FinitePoints
{
  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Vector3d> normals; ///< vectors of length 1 or 0; none if the cloud has none
};

bool haveNormals(const std::vector<OrientedPointsView>& views)
{
  bool have = false;
  for (const OrientedPointsView& view : views)
  {
    if (!view.positions.empty() && view.normals.empty())
    {
      return false;
    }
    have = have || !view.normals.empty();
  }
  return have;
}

/// Collects the finite points, and fills in the counts and the bounds of the report. It runs on one
/// thread, as it takes little of the time and reads each number once.
FinitePoints collect(const std::vector<OrientedPointsView>& views, CloudReport& report)
{
  FinitePoints points;
  for (const OrientedPointsView& view : views)
  {
    report.points += view.positions.size();
    for (std::size_t i = 0; i < view.positions.size(); ++i)
    {
      const Eigen::Vector3d position = view.positions[i];
      const Eigen::Vector3d normal =
        report.hasNormals ? view.normals[i] : Eigen::Vector3d(Eigen::Vector3d::Zero());
      if (!position.allFinite() || !normal.allFinite())
      {
        ++report.nonFinite;
        continue;
      }
      points.positions.push_back(position);
      report.bounds.extend(position);
      if (report.hasNormals)
      {
        // Unit normals stored as float have length 1 to about 1e-7, those stored as text to 1e-6 or
        // worse.
        const double length = normal.stableNorm();
        const bool isZero = normal == Eigen::Vector3d::Zero();
        report.zeroNormals += isZero;
        report.nonUnitNormals += !isZero && !(std::abs(length - 1) <= 1e-3);
        points.normals.push_back(isZero ? normal : unitNormal(normal));
      }
    }
  }
  return points;
}

/// The sum of the normals at each place.
std::vector<Eigen::Vector3d> sumsOfNormals(
  const DistinctPoints& places, const std::vector<Eigen::Vector3d>& normals)
{
  std::vector<Eigen::Vector3d> sums(places.size(), Eigen::Vector3d::Zero());
  for (std::size_t place = 0; place < places.size(); ++place)
  {
    for (const std::uint32_t* point = places.begin(place); point != places.end(place); ++point)
    {
      sums[place] += normals[*point];
    }
  }
  return sums;
}

/// Sums up the distances of scaled places from their nearest others, in the caller's unit of
/// length.
Spacing spacingOf(std::vector<double> distances, double scale)
{
  // Distances are sorted before they are summed, so that the mean does not depend on the order of
  // the points.
  std::sort(distances.begin(), distances.end());
  const double sum = std::accumulate(distances.begin(), distances.end(), 0.0);
  return {distances.front() / scale, distances[distances.size() / 2] / scale,
    sum / static_cast<double>(distances.size()) / scale, distances.back() / scale};
}

/// The number of pairs of a place and a neighbour, and of those with opposite normals.
struct Pairs
{
  std::size_t all = 0, opposite = 0;
};

void lookAtNeighbors(const DistinctPoints& places, const std::vector<Eigen::Vector3d>& normals,
  CloudReport& report, Executor& executor)
{
  constexpr std::size_t placesPerBlock = 4096, neighborsCompared = 8;
  const NeighborSearch search(places, executor);
  std::vector<double> distances(places.size());
  std::vector<Pairs> pairsOfBlocks((places.size() + placesPerBlock - 1) / placesPerBlock);
  runBlocks(
    places.size(), placesPerBlock,
    [&](std::size_t block, std::size_t first, std::size_t last)
    {
      std::vector<Neighbor> neighbors;
      NeighborSearch::Last lastSearch;
      Pairs pairs;
      for (std::size_t place = first; place < last; ++place)
      {
        search.find(place, normals.empty() ? 1 : neighborsCompared, neighbors, lastSearch);
        const Eigen::Vector3d offset =
          places.positions()[neighbors[0].place] - places.positions()[place];
        distances[place] = offset.stableNorm();
        if (normals.empty() || normals[place] == Eigen::Vector3d::Zero())
        {
          continue;
        }
        for (const Neighbor& neighbor : neighbors)
        {
          const Eigen::Vector3d& other = normals[neighbor.place];
          pairs.all += other != Eigen::Vector3d::Zero();
          pairs.opposite += normals[place].dot(other) < 0;
        }
      }
      pairsOfBlocks[block] = pairs;
    },
    executor);

  report.spacing = spacingOf(std::move(distances), places.scale());
  Pairs pairs;
  for (const Pairs& ofBlock : pairsOfBlocks)
  {
    pairs.all += ofBlock.all;
    pairs.opposite += ofBlock.opposite;
  }
  report.oppositeNeighbors =
    pairs.all > 0 ? static_cast<double>(pairs.opposite) / static_cast<double>(pairs.all) : 0;
}

} // namespace

CloudReport reportOn(const std::vector<OrientedPointsView>& views, Executor& executor)
{
  boundsOf(views); // throws for what cannot be examined
  CloudReport report;
  report.hasNormals = haveNormals(views);
  const FinitePoints points = collect(views, report);
  const DistinctPoints places(points.positions, unitScale(report.bounds), executor);
  report.places = places.size();
  report.duplicates = points.positions.size() - places.size();
  if (places.size() > 1)
  {
    const std::vector<Eigen::Vector3d> normals =
      report.hasNormals ? sumsOfNormals(places, points.normals) : std::vector<Eigen::Vector3d>();
    lookAtNeighbors(places, normals, report, executor);
  }
  // Points at one place have no areas, and so no field.
  if (report.hasNormals && places.size() > 1 &&
      report.points > report.nonFinite + report.zeroNormals)
  {
    PointCloud cloud = sanitize(views, executor);
    report.equalNormalsExcept = equalNormalsExcept(cloud, executor);
    const DistinctPoints usable(cloud.positions, unitScale(cloud.bounds), executor);
    cloud.areas = voronoiAreas(cloud, usable, defaultNeighbors, executor);
    report.orientation = orientationOf(cloud, executor);
  }
  return report;
}

} // namespace winding
