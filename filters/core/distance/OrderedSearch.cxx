// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "distance/OrderedSearch.h"

namespace winding
{

namespace
{

/// A task ends when its searches have looked at this number of items, in some hundredths of a
/// second, and after one search at least.
constexpr std::size_t mostItemsPerTask = 1 << 22;

/// Parts with fewer samples are not put in order.
constexpr std::size_t fewSamples = 8;

} // namespace

std::vector<PlaceSamples::Part> OrderedSearch::run(const PlaceSamples::Part& part)
{
  this->descend(part);
  return std::move(left_);
}

void OrderedSearch::descend(const PlaceSamples::Part& part)
{
  if (items_ > mostItemsPerTask)
  {
    left_.push_back(part);
    return;
  }
  if (PlaceSamples::count(part) <= fewSamples)
  {
    this->searchEach(part);
    return;
  }
  const Bounds box = PlaceSamples::boxOf(part);
  if (box.min() == box.max())
  {
    // Any number of samples may be at one place.
    std::uint32_t number = NearestNumbers::none;
    const double squared = this->searched(box.min(), number);
    PlaceSamples::forEach(part,
      [&](const Eigen::Vector3d&, std::size_t sample) { samples_.write(squared, number, sample); });
    return;
  }
  const auto halves = PlaceSamples::halves(part);
  this->descend(halves.first);
  this->descend(halves.second);
}

void OrderedSearch::searchEach(const PlaceSamples::Part& part)
{
  for (Place* place = part.first; place != part.last; ++place)
  {
    if (items_ > mostItemsPerTask)
    {
      left_.push_back({place, part.last});
      return;
    }
    std::uint32_t number = NearestNumbers::none;
    const double squared = this->searched(place->position, number);
    samples_.write(squared, number, place->sample);
  }
}

/// Returns the square of a place's distance. Sets `number` to the nearest item's, if it is wanted.
double OrderedSearch::searched(const Eigen::Vector3d& position, std::uint32_t& number)
{
  Nearest nearest = {squaredLimit_, {0, 0, 0}};
  if (hasFound_)
  {
    tree_.compare(position, lastItem_, nearest);
  }
  items_ += tree_.findNearest(position, 0, nearest);
  if (nearest.squared < squaredLimit_)
  {
    hasFound_ = true;
    lastItem_ = nearest.item;
  }
  if (const NearestNumbers* const numbers = samples_.numbers())
  {
    number = numbers->find(&position, 1, lastItem_).number;
  }
  return nearest.squared;
}

} // namespace winding
