// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/NoisySheets.h"

#include "cloud/OrientedSites.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace winding
{

namespace
{

constexpr std::size_t placesPerBlock = 512;

double gaussian(double x)
{
  return std::exp(-x * x / 2);
}

/// A plane near the origin: the points x with normal · x = offset.
struct Plane
{
  Eigen::Vector3d normal;
  double offset;

  double distanceOf(const Eigen::Vector3d& x) const { return normal.dot(x) - offset; }
};

/// Sums over points with weights, which the plane of least squares follows from.
class WeightedPoints
{
public:
  void add(const Eigen::Vector3d& point, double weight)
  {
    weight_ += weight;
    sum_ += weight * point;
    squares_ += weight * point * point.transpose();
  }

  /// The plane of least squares, with its normal on the side of another plane's; that plane where
  /// there is none.
  Plane planeLike(const Plane& other) const
  {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(
      squares_ - sum_ * sum_.transpose() / weight_);
    Eigen::Vector3d normal = spread.eigenvectors().col(0).normalized();
    if (!normal.allFinite())
    {
      return other;
    }
    normal *= normal.dot(other.normal) < 0 ? -1 : 1;
    return {normal, normal.dot(sum_) / weight_};
  }

private:
  double weight_ = 0;
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares_ = Eigen::Matrix3d::Zero();
};

/// The places around one, itself first, as seen from it in units of its spacing.
void findOffsets(const DistinctPoints& places, const NeighborGraph& graph, std::size_t place,
  double spacing, std::vector<Eigen::Vector3d>& offsets)
{
  offsets.assign(1, Eigen::Vector3d::Zero());
  for (const std::uint32_t* to = graph.begin(place);
       to != graph.end(place, graph.neighborsPerPlace()); ++to)
  {
    offsets.emplace_back((places.positions()[*to] - places.positions()[place]) / spacing);
  }
}

/// Calls work(place, offsets) for all places, with the places around each (findOffsets()).
template <class Work>
void forEachOffsets(const DistinctPoints& places, const NeighborGraph& graph,
  const std::vector<double>& spacings, const Work& work, Executor& executor)
{
  runBlocks(
    places.size(), placesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      std::vector<Eigen::Vector3d> offsets;
      for (std::size_t place = first; place < last; ++place)
      {
        findOffsets(places, graph, place, spacings[place], offsets);
        work(place, offsets);
      }
    },
    executor);
}

/// Follows a plane to the sheet that it is on, and counts the points that lie on it. A sheet
/// that passes far from the origin counts less.
double followSheet(const std::vector<Eigen::Vector3d>& points, Plane& plane)
{
  constexpr double width = 0.3, reach = 2 * width;
  for (const double wider : {2.0, 1.4, 1.0, 1.0})
  {
    WeightedPoints near;
    for (const Eigen::Vector3d& point : points)
    {
      near.add(point, gaussian(plane.distanceOf(point) / (wider * width)));
    }
    plane = near.planeLike(plane);
  }
  double onSheet = 0;
  for (const Eigen::Vector3d& point : points)
  {
    onSheet += gaussian(plane.distanceOf(point) / width);
  }
  return onSheet * gaussian(plane.offset / reach);
}

} // namespace

SheetPlanes sheetPlanes(const DistinctPoints& places, const NeighborGraph& graph,
  const std::vector<double>& spacings, const std::vector<std::size_t>& neighbors,
  Executor& executor)
{
  SheetPlanes planes = {std::vector<Eigen::Vector3d>(places.size()), places.positions()};
  forEachOffsets(
    places, graph, spacings,
    [&](std::size_t place, const std::vector<Eigen::Vector3d>& offsets)
    {
      double most = -1;
      Plane best = {Eigen::Vector3d(0, 0, 1), 0};
      for (const std::size_t count : neighbors)
      {
        Plane plane = {planeNormalOf(places, graph, place, count), 0};
        const double onSheet = followSheet(offsets, plane);
        if (onSheet > most)
        {
          most = onSheet;
          best = plane;
        }
      }
      planes.normals[place] = best.normal;
      planes.feet[place] += spacings[place] * best.offset * best.normal;
    },
    executor);
  return planes;
}

std::vector<Eigen::Vector3d> smoothedAlongSheets(const DistinctPoints& places,
  const NeighborGraph& graph, const std::vector<double>& spacings,
  const std::vector<Eigen::Vector3d>& normals, Executor& executor)
{
  constexpr double near = 0.7, around = 2;
  constexpr int rounds = 3;
  std::vector<Eigen::Vector3d> means(normals), smoothed(normals);
  forEachOffsets(
    places, graph, spacings,
    [&](std::size_t place, const std::vector<Eigen::Vector3d>& offsets)
    {
      Eigen::Vector3d sum = normals[place];
      for (std::size_t i = 1; i < offsets.size(); ++i)
      {
        const Eigen::Vector3d& normal = normals[graph.begin(place)[i - 1]];
        sum +=
          gaussian(normal.dot(offsets[i]) / near) * gaussian(offsets[i].norm() / around) * normal;
      }
      // Normals that cancel each other leave none.
      const double length = sum.norm();
      means[place] =
        length > 0 && std::isfinite(length) ? Eigen::Vector3d(sum / length) : normals[place];
    },
    executor);
  forEachOffsets(
    places, graph, spacings,
    [&](std::size_t place, const std::vector<Eigen::Vector3d>& offsets)
    {
      Plane plane = {means[place], 0};
      for (int round = 0; round < rounds; ++round)
      {
        WeightedPoints onSheet;
        onSheet.add(offsets[0], 1);
        int similar = 0;
        for (std::size_t i = 1; i < offsets.size(); ++i)
        {
          const Eigen::Vector3d& normal = means[graph.begin(place)[i - 1]];
          if (areSimilar(normal, plane.normal))
          {
            onSheet.add(
              offsets[i], normal.dot(plane.normal) * gaussian(plane.distanceOf(offsets[i]) / near));
            ++similar;
          }
        }
        constexpr int fewest = 3;
        plane = similar >= fewest ? onSheet.planeLike(plane) : plane;
      }
      smoothed[place] = plane.normal;
    },
    executor);
  return smoothed;
}

} // namespace winding
