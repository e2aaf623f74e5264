// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "distance/NearestItems.h"

#include <algorithm>

namespace winding
{

namespace
{

/// Triangles of a squared radius larger than this times the square of a cell's side are looked at
/// by their distances, since the radius says too little.
constexpr double largeForCell = 1;

} // namespace

NearestItems::NearestItems(const DistanceTree& tree)
  : tree_(tree)
  , rounding_(tree)
  , all_(tree.noCandidates())
{
}

void NearestItems::findNearest(NearestCell* cells, std::size_t count, const Candidates& candidates)
{
  block_.count = count;
  for (std::size_t i = 0; i < count; ++i)
  {
    block_.set(i, cells[i].center());
  }
  Nearest nearest[samplesAtOnce];
  tree_.findNearestOfEach(candidates.numbers(), candidates.size(), block_, nearest);
  work_ += static_cast<double>(samplesAtOnce * candidates.size());
  for (std::size_t i = 0; i < count; ++i)
  {
    rounding_.setNearest(cells[i], nearest[i]);
  }
}

/// Sets places_ to the places of the candidates that pass the test of Candidates, and of the one
/// that the nearest point of the centre lies on.
void NearestItems::findPlaces(const NearestCell& cell, const Candidates& candidates)
{
  const Eigen::Vector3d center = cell.center();
  CandidateTest test;
  for (int axis = 0; axis < 3; ++axis)
  {
    test.nearest[axis] = cell.nearest.position[axis];
    test.gradient[axis] = -2 * (center[axis] - cell.nearest.position[axis]);
    test.size[axis] = 2 * std::max(center[axis] - cell.low[axis], cell.high[axis] - center[axis]);
  }
  test.slack = rounding_.slackOf(cell);
  candidates.find(test, places_);
  work_ += static_cast<double>(candidates.size());
  const std::uint32_t* const numbers = candidates.numbers();
  const auto isHolder = [&](std::uint32_t place)
  {
    return numbers[place] == cell.nearest.item;
  };
  if (std::none_of(places_.begin(), places_.end(), isHolder))
  {
    // It is not among the candidates if it is beyond the limit.
    const std::uint32_t* const end = numbers + candidates.size();
    const std::uint32_t* const holder = std::find(numbers, end, cell.nearest.item);
    if (holder != end)
    {
      places_.push_back(static_cast<std::uint32_t>(holder - numbers));
    }
  }
}

/// Removes the places of large triangles that are too far to be nearest to a sample of a cell:
/// farther from all of its corners than the nearest point of its centre.
void NearestItems::removeFar(const NearestCell& cell, const Candidates& candidates)
{
  const double side = (cell.high - cell.low).maxCoeff();
  const double mostSquared = largeForCell * side * side;
  alignas(64) double limits[samplesAtOnce];
  block_.count = 0;
  const auto isFar = [&](std::uint32_t place)
  {
    const std::uint32_t number = candidates.numbers()[place];
    if (candidates.squaredRadius(place) <= mostSquared || number == cell.nearest.item)
    {
      return false;
    }
    if (block_.count == 0)
    {
      this->setCorners(cell, limits);
    }
    work_ += samplesAtOnce;
    return !tree_.isNearer(number, block_, limits);
  };
  places_.erase(std::remove_if(places_.begin(), places_.end(), isFar), places_.end());
}

/// Sets the block to the corners of a cell, and the squared distances beyond which nothing can be
/// nearest to them. The triangle and the nearest one may both be thin.
void NearestItems::setCorners(const NearestCell& cell, double* squaredLimits)
{
  const double rounding = rounding_.of(cell);
  block_.count = samplesAtOnce;
  for (std::size_t n = 0; n < samplesAtOnce; ++n)
  {
    const Eigen::Vector3d corner((n & 1 ? cell.high : cell.low)[0],
      (n & 2 ? cell.high : cell.low)[1], (n & 4 ? cell.high : cell.low)[2]);
    block_.set(n, corner);
    const double distance = (corner - cell.nearest.position).norm() + rounding;
    squaredLimits[n] = distance * distance + 2 * rounding_.squareOfThin();
  }
}

void NearestItems::keep(const NearestCell& cell, const std::vector<NearItems>& runs, Candidates& to)
{
  tree_.assign(runs, all_);
  this->keep(cell, all_, to);
}

void NearestItems::keep(const NearestCell& cell, const Candidates& candidates, Candidates& to)
{
  this->findPlaces(cell, candidates);
  this->removeFar(cell, candidates);
  to.assign(candidates, places_);
}

const std::vector<std::uint32_t>& NearestItems::numbers(
  const NearestCell& cell, const Candidates& candidates)
{
  this->findPlaces(cell, candidates);
  numbers_.resize(places_.size());
  std::transform(places_.begin(), places_.end(), numbers_.begin(),
    [&](std::uint32_t place) { return candidates.numbers()[place]; });
  return numbers_;
}

} // namespace winding
