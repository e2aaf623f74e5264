#include "distance/OrderedSearch.h"

namespace winding
{

namespace
{

/// A task ends after so many items, or a part of few samples: some hundredths of a second.
constexpr std::size_t mostItemsPerTask = 1 << 22;

/// Parts of so few samples are not put in order.
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
  }
  else if (PlaceSamples::count(part) > fewSamples)
  {
    const auto halves = PlaceSamples::halves(part);
    this->descend(halves.first);
    this->descend(halves.second);
  }
  else
  {
    PlaceSamples::forEach(part, [this](const Eigen::Vector3d& position, std::size_t sample)
      { samples_.write(this->searched(position), sample); });
  }
}

/// The square of a sample's distance. Any number of samples may be at one place.
double OrderedSearch::searched(const Eigen::Vector3d& position)
{
  if (hasSearched_ && position == lastPosition_)
  {
    return lastSquared_;
  }
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
  hasSearched_ = true;
  lastPosition_ = position;
  lastSquared_ = nearest.squared;
  return lastSquared_;
}

} // namespace winding
