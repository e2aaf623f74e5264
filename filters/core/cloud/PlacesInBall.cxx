// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/PlacesInBall.h"

#include <algorithm>

namespace winding
{

void PlacesInBall::start(const Eigen::Vector3d& center, double radius)
{
  center_ = center;
  radius_ = radius;
  places_.clear();
}

bool PlacesInBall::findNearest(std::uint32_t place, const Eigen::Vector3d& position,
  std::size_t count, double likely, double atMost, std::vector<Neighbor>& neighbors)
{
  // The terms are more than what rounding and underflow may give to distances and squares.
  const double within = radius_ - (position - center_).norm() - 1e-9 * radius_;
  const double bound = std::min(atMost, within * within - 1e-290);
  if (!(within > 0 && std::min(likely, bound) > 1e-290) || places_.size() <= count)
  {
    return false;
  }
  double least = std::min(likely, bound);
  std::size_t found = this->findWithin(least, place, position);
  if (found < count && least < bound)
  {
    least = bound;
    found = this->findWithin(least, place, position);
  }
  if (found < count)
  {
    return false;
  }
  this->sortNearest(found, count, least, neighbors);
  return true;
}

/// Lists the other places up to a squared distance away, and returns their number.
std::size_t PlacesInBall::findWithin(
  double squaredDistance, std::uint32_t place, const Eigen::Vector3d& position)
{
  // Every place is written, and stays if it counts: branches would be mispredicted.
  found_.resize(std::max(found_.size(), places_.size()));
  std::size_t found = 0;
  for (const Place& other : places_)
  {
    found_[found] = {other.number, squaredDistanceBetween(other.position, position)};
    found += found_[found].squaredDistance <= squaredDistance && other.number != place;
  }
  return found;
}

/// Moves the nearest of the places found to `neighbors`, in order. Squares of distances on a
/// surface are spread evenly, so that each of as many ranges of them as there are places holds few.
void PlacesInBall::sortNearest(
  std::size_t found, std::size_t count, double bound, std::vector<Neighbor>& neighbors)
{
  const auto ranges = static_cast<int>(found);
  const double rangesPerSquare = ranges / bound;
  const auto rangeOf = [&](std::size_t i)
  {
    return std::min(static_cast<int>(found_[i].squaredDistance * rangesPerSquare), ranges - 1);
  };
  starts_.assign(found + 1, 0);
  for (std::size_t i = 0; i < found; ++i)
  {
    ++starts_[static_cast<std::size_t>(rangeOf(i)) + 1];
  }
  int last = 0; // the range of the last of the nearest
  for (std::uint32_t* start = starts_.data(); (start[1] += start[0]) < count; ++start)
  {
    ++last;
  }
  neighbors.resize(starts_[static_cast<std::size_t>(last) + 1]);
  for (std::size_t i = 0; i < found; ++i)
  {
    const int range = rangeOf(i);
    if (range <= last)
    {
      neighbors[starts_[static_cast<std::size_t>(range)]++] = found_[i];
    }
  }
  // Insertion is the fastest way to sort places that are nearly in order already.
  for (std::size_t i = 1; i < neighbors.size(); ++i)
  {
    const Neighbor neighbor = neighbors[i];
    std::size_t j = i;
    for (; j > 0 && isNearer(neighbor, neighbors[j - 1]); --j)
    {
      neighbors[j] = neighbors[j - 1];
    }
    neighbors[j] = neighbor;
  }
  neighbors.resize(count);
}

} // namespace winding
