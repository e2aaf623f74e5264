// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/Viewpoints.h"

#include "base/Directions.h"
#include "base/Progress.h"
#include "base/Refusal.h"
#include "cloud/NormalEstimation.h"
#include "cloud/SearchedPositions.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <utility>

namespace winding
{

namespace
{

[[noreturn]] void refuse()
{
  Message message(Parameter::toward, "is no position and no direction");
  message.remedies = {{"give X Y Z, direction X Y Z, up or down", {}}};
  throw Refusal(std::move(message));
}

double opposedShare(const DistinctPoints& places, const NeighborGraph& graph,
  const std::vector<Eigen::Vector3d>& normals)
{
  constexpr std::size_t nearest = 8;
  constexpr std::ptrdiff_t few = 2;
  constexpr double opposite = -0.7, across = 0.3; // the two sides of a thin wall lie farther across
  std::size_t opposed = 0;
  for (std::size_t place = 0; place < normals.size(); ++place)
  {
    const Eigen::Vector3d& normal = normals[place];
    const auto others = std::count_if(graph.begin(place), graph.end(place, nearest),
      [&](std::uint32_t neighbor)
      {
        const Eigen::Vector3d offset = places.positions()[neighbor] - places.positions()[place];
        return normal.dot(normals[neighbor]) < opposite &&
               std::abs(normal.dot(offset)) < across * offset.norm();
      });
    opposed += others >= few ? 1 : 0;
  }
  return static_cast<double>(opposed) / static_cast<double>(normals.size());
}

} // namespace

Viewpoints::Viewpoints(const std::string& text)
{
  const std::string words = trimmed(text);
  direction_ = directionIn(words);
  if (!direction_.isZero())
  {
    return;
  }
  std::istringstream positions(words);
  for (std::string position; std::getline(positions, position, ';');)
  {
    const std::vector<double> numbers = numbersIn(position);
    if (numbers.size() != 3)
    {
      refuse();
    }
    positions_.emplace_back(numbers[0], numbers[1], numbers[2]);
  }
}

std::string Viewpoints::textAlong(
  const Eigen::Matrix3d& inverseAxes, const Eigen::Vector3d& origin) const
{
  if (!direction_.isZero())
  {
    return "direction " + textOf(inverseAxes * direction_);
  }
  std::string text;
  for (const Eigen::Vector3d& position : positions_)
  {
    text += (text.empty() ? "" : "; ") + textOf(inverseAxes * (position - origin));
  }
  return text;
}

std::vector<Eigen::Vector3d> Viewpoints::directionsFrom(
  const DistinctPoints& places, Executor& executor) const
{
  std::vector<Eigen::Vector3d> directions(places.size(), direction_);
  if (positions_.empty())
  {
    return directions;
  }
  // Sorted, so that their order makes no difference to places that are equally near to two.
  std::vector<Eigen::Vector3d> sorted;
  for (const Eigen::Vector3d& position : positions_)
  {
    sorted.emplace_back(position.unaryExpr(
      [&places](double coordinate) { return scaledCoordinate(coordinate, places.scale()); }));
  }
  std::sort(sorted.begin(), sorted.end(),
    [](const Eigen::Vector3d& a, const Eigen::Vector3d& b)
    { return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3); });
  const SearchedPositions searched = {sorted.data(), sorted.size()};
  const SearchedPositions::Tree tree(3, searched, nanoflann::KDTreeSingleIndexAdaptorParams(16));
  forEachItem(
    places.size(),
    [&](std::size_t i)
    {
      std::uint32_t nearest = 0;
      double square = 0;
      const Eigen::Vector3d& place = places.positions()[i];
      static_cast<void>(tree.knnSearch(place.data(), 1, &nearest, &square)); // one is found
      directions[i] = unitOrZero(sorted[nearest] - place);
    },
    executor);
  return directions;
}

SeenNormals normalsToward(const std::vector<Eigen::Vector3d>& directions,
  const DistinctPoints& places, int neighbors, Executor& executor)
{
  constexpr double grazing = 0.26; // the sine of 15°
  if (places.size() < 2)
  {
    std::vector<Eigen::Vector3d> normals = directions;
    for (Eigen::Vector3d& normal : normals)
    {
      normal = normal.isZero() ? Eigen::Vector3d(0, 0, 1) : normal;
    }
    return {places.byPoint(normals)};
  }
  Progress progress(executor);
  const auto count = static_cast<std::size_t>(std::max(neighbors, 3));
  progress.set(0, 0.5);
  const NeighborGraph graph(places, count, executor);
  progress.set(0.5, 0.6);
  std::vector<Eigen::Vector3d> normals = planeNormals(places, graph, count, executor);
  std::vector<double> clearness(places.size());
  for (std::size_t place = 0; place < places.size(); ++place)
  {
    const double toward = normals[place].dot(directions[place]);
    normals[place] *= toward < 0 ? -1 : 1;
    clearness[place] = std::abs(toward);
  }
  progress.set(0.6, 1);
  orientFrom(places, graph, clearness, grazing, normals, executor);
  return {places.byPoint(normals), opposedShare(places, graph, normals)};
}

} // namespace winding
