// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/NeighborGraph.h"

#include "cloud/NeighborSearch.h"
#include "cloud/OrientedSites.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace winding
{

namespace
{

constexpr std::size_t placesPerBlock = 512;

/// Calls work(place, begin, end) with the nearest neighbours of every place.
template <class Work>
void forEachNeighbors(
  const DistinctPoints& places, std::size_t count, const Work& work, Executor& executor)
{
  const NeighborSearch search(places, executor);
  runBlocks(
    places.size(), placesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      std::vector<Neighbor> found;
      std::vector<std::uint32_t> neighbors;
      NeighborSearch::Last lastSearch;
      for (std::size_t place = first; place < last; ++place)
      {
        search.find(place, count, found, lastSearch);
        neighbors.resize(found.size());
        std::transform(found.begin(), found.end(), neighbors.begin(),
          [](const Neighbor& neighbor) { return neighbor.place; });
        work(place, neighbors.data(), neighbors.data() + neighbors.size());
      }
    },
    executor);
}

/// The plane through a place and its nearest neighbours.
struct NeighborPlane
{
  Eigen::Vector3d normal; ///< direction in which they spread least; of unit length, in either
                          ///< sense; any one across their line where they are on one
  double deviation;       ///< estimated root mean square of their distances from the plane
};

/// The plane through a place and its neighbours begin … end − 1.
NeighborPlane planeThrough(const DistinctPoints& places, std::size_t place,
  const std::uint32_t* begin, const std::uint32_t* end)
{
  // Offsets are taken in units of the neighbourhood's size, so that squares stay within range.
  const Eigen::Vector3d center = places.positions()[place];
  double size = 0;
  for (const std::uint32_t* neighbor = begin; neighbor != end; ++neighbor)
  {
    size = std::max(size, (places.positions()[*neighbor] - center).cwiseAbs().maxCoeff());
  }
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (const std::uint32_t* neighbor = begin; neighbor != end; ++neighbor)
  {
    const Eigen::Vector3d offset = (places.positions()[*neighbor] - center) / size;
    sum += offset;
    squares += offset * offset.transpose();
  }
  const double points = static_cast<double>(end - begin + 1);
  squares -= sum * sum.transpose() / points;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(squares);
  const Eigen::Vector3d normal = spread.eigenvectors().col(0).normalized();
  if (!normal.allFinite())
  {
    return {{0, 0, 1}, 0};
  }
  // A plane takes three degrees of freedom.
  const double variance = std::max(0.0, spread.eigenvalues()[0]) / std::max(1.0, points - 3);
  return {normal, size * std::sqrt(variance)};
}

/// Calls work(place, plane) with the plane of every place and of neighbours that a search finds.
template <class Work>
void forEachPlane(
  const DistinctPoints& places, std::size_t count, const Work& work, Executor& executor)
{
  forEachNeighbors(
    places, count,
    [&](std::size_t place, const std::uint32_t* begin, const std::uint32_t* end)
    { work(place, planeThrough(places, place, begin, end)); },
    executor);
}

/// Calls work(place, plane) with the plane of every place, of its neighbours in the graph or, where
/// these are too few, of those that a search finds.
template <class Work>
void forEachPlane(const DistinctPoints& places, const NeighborGraph& graph, std::size_t count,
  const Work& work, Executor& executor)
{
  const std::size_t others = places.size() - 1;
  if (std::min(count, others) > graph.neighborsPerPlace())
  {
    forEachPlane(places, count, work, executor);
    return;
  }
  runBlocks(
    places.size(), placesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      for (std::size_t place = first; place < last; ++place)
      {
        work(place, planeThrough(places, place, graph.begin(place), graph.end(place, count)));
      }
    },
    executor);
}

} // namespace

NeighborGraph::NeighborGraph(const DistinctPoints& places, std::size_t most, Executor& executor)
  : most_(std::min({most, mostPerPlace, places.size() - 1}))
  , neighbors_(places.size() * most_)
{
  forEachNeighbors(
    places, most_,
    [&](std::size_t place, const std::uint32_t* begin, const std::uint32_t* end)
    { std::copy(begin, end, neighbors_.data() + place * most_); },
    executor);
}

Eigen::Vector3d planeNormalOf(
  const DistinctPoints& places, const NeighborGraph& graph, std::size_t place, std::size_t count)
{
  return planeThrough(places, place, graph.begin(place), graph.end(place, count)).normal;
}

std::vector<Eigen::Vector3d> planeNormals(
  const DistinctPoints& places, std::size_t count, Executor& executor)
{
  std::vector<Eigen::Vector3d> normals(places.size());
  forEachPlane(
    places, count,
    [&](std::size_t place, const NeighborPlane& plane) { normals[place] = plane.normal; },
    executor);
  return normals;
}

PlacePlanes placePlanes(const DistinctPoints& places, std::size_t count, Executor& executor)
{
  PlacePlanes planes = {
    std::vector<Eigen::Vector3d>(places.size()), std::vector<double>(places.size())};
  forEachPlane(
    places, count,
    [&](std::size_t place, const NeighborPlane& plane)
    {
      planes.normals[place] = plane.normal;
      planes.deviations[place] = plane.deviation;
    },
    executor);
  return planes;
}

std::vector<Eigen::Vector3d> planeNormals(
  const DistinctPoints& places, const NeighborGraph& graph, std::size_t count, Executor& executor)
{
  std::vector<Eigen::Vector3d> normals(places.size());
  forEachPlane(
    places, graph, count,
    [&](std::size_t place, const NeighborPlane& plane) { normals[place] = plane.normal; },
    executor);
  return normals;
}

std::vector<double> planeDeviations(
  const DistinctPoints& places, const NeighborGraph& graph, std::size_t count, Executor& executor)
{
  std::vector<double> deviations(places.size());
  forEachPlane(
    places, graph, count,
    [&](std::size_t place, const NeighborPlane& plane) { deviations[place] = plane.deviation; },
    executor);
  return deviations;
}

std::vector<Eigen::Vector3d> sheetNormals(const DistinctPoints& places, const NeighborGraph& graph,
  const std::vector<Eigen::Vector3d>& normals, std::size_t count, Executor& executor)
{
  constexpr std::size_t fewest = 3;
  std::vector<Eigen::Vector3d> ofSheets(normals);
  runBlocks(
    places.size(), placesPerBlock,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      std::vector<std::uint32_t> onSheet;
      for (std::size_t place = first; place < last; ++place)
      {
        onSheet.clear();
        std::copy_if(graph.begin(place), graph.end(place, count), std::back_inserter(onSheet),
          [&](std::uint32_t neighbor) { return areSimilar(normals[neighbor], normals[place]); });
        if (onSheet.size() >= fewest)
        {
          const Eigen::Vector3d normal =
            planeThrough(places, place, onSheet.data(), onSheet.data() + onSheet.size()).normal;
          ofSheets[place] = normal.dot(normals[place]) < 0 ? Eigen::Vector3d(-normal) : normal;
        }
      }
    },
    executor);
  return ofSheets;
}

NeighborStep stepBetween(const DistinctPoints& places, const std::vector<Eigen::Vector3d>& normals,
  std::size_t from, std::size_t to)
{
  const Eigen::Vector3d along = (places.positions()[to] - places.positions()[from]).normalized();
  const double cosine = std::abs(normals[from].dot(normals[to]));
  const double climb = std::abs(normals[from].dot(along)) + std::abs(normals[to].dot(along));
  return {static_cast<float>(1 - cosine + climb / 2), static_cast<std::uint32_t>(from),
    static_cast<std::uint32_t>(to)};
}

} // namespace winding
