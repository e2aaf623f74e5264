// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "source/SnappedPoints.h"

#include "base/Refusal.h"
#include "source/DistinctPoints.h"
#include "source/PlaceHash.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace winding
{

namespace
{

/// The places that have stayed, in cells as large as the tolerance or larger.
class StayedPlaces
{
public:
  StayedPlaces(const std::vector<Eigen::Vector3d>& positions, double tolerance)
    : positions_(positions)
    , tolerance_(tolerance)
    , side_(std::max(tolerance, leastSide))
  {
  }

  /// Returns the nearest place within the tolerance of another, which stays itself where there is
  /// none.
  std::uint32_t nearestOrSelf(std::uint32_t place)
  {
    const Eigen::Vector3d& position = positions_[place];
    const Cell own = {std::floor(position[0] / side_), std::floor(position[1] / side_),
      std::floor(position[2] / side_)};
    std::uint32_t nearest = place;
    double least = tolerance_;
    for (int n = 0; n < 27; ++n)
    {
      const Cell cell = {own[0] + n % 3 - 1, own[1] + n / 3 % 3 - 1, own[2] + n / 9 - 1};
      const auto [begin, end] = places_.equal_range(cell);
      for (auto stayed = begin; stayed != end; ++stayed)
      {
        const double distance = (positions_[stayed->second] - position).norm();
        if (distance < least ||
            (distance == least && (nearest == place || stayed->second < nearest)))
        {
          least = distance;
          nearest = stayed->second;
        }
      }
    }
    if (nearest == place)
    {
      places_.emplace(own, place);
    }
    return nearest;
  }

private:
  using Cell = std::array<double, 3>;

  const std::vector<Eigen::Vector3d>& positions_;
  /// Numbers of smaller cells of scaled positions, which are about 1, would not be exact.
  static constexpr double leastSide = 1e-15;

  double tolerance_;
  double side_; ///< of a cell
  std::unordered_multimap<Cell, std::uint32_t, PlaceHash> places_;
};

} // namespace

std::vector<std::vector<double>> snappedPoints(
  const std::vector<VectorsView>& points, double tolerance, Executor& executor)
{
  std::vector<Eigen::Vector3d> positions; // finite ones
  for (const VectorsView& view : points)
  {
    for (std::size_t i = 0; i < view.size(); ++i)
    {
      const Eigen::Vector3d position = view[i];
      if (position.allFinite())
      {
        positions.push_back(position.array() + 0.0); // no −0
      }
    }
  }
  if (positions.size() > std::numeric_limits<std::uint32_t>::max())
  {
    throw Refusal("the source has more than 2^32 - 1 points");
  }
  const double scale = unitScaleOf(positions);
  const DistinctPoints places(positions, scale, executor);
  StayedPlaces stayed(places.positions(), tolerance * scale);
  std::vector<Eigen::Vector3d> moved(places.size());
  // Each place depends on those before it, so that blocks only let an interruption through.
  constexpr std::size_t placesPerBlock = 65536;
  for (std::size_t first = 0; first < places.size(); first += placesPerBlock)
  {
    const auto move = [&](std::size_t)
    {
      for (std::size_t i = first; i < std::min(first + placesPerBlock, places.size()); ++i)
      {
        const auto place = static_cast<std::uint32_t>(i);
        const std::uint32_t target = tolerance > 0 ? stayed.nearestOrSelf(place) : place;
        moved[i] = positions[*places.begin(target)];
      }
    };
    executor.runBriefly(1, move);
  }
  const std::vector<Eigen::Vector3d> ofPoints = places.byPoint(moved);
  std::vector<std::vector<double>> result;
  std::size_t next = 0;
  for (const VectorsView& view : points)
  {
    std::vector<double>& own = result.emplace_back();
    own.reserve(3 * view.size());
    for (std::size_t i = 0; i < view.size(); ++i)
    {
      const Eigen::Vector3d given = view[i];
      const Eigen::Vector3d& position = given.allFinite() ? ofPoints[next++] : given;
      own.insert(own.end(), position.data(), position.data() + 3);
    }
  }
  return result;
}

} // namespace winding
