// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/NeighborSearch.h"

#include "cloud/PlacesInBall.h"
#include "cloud/SearchedPositions.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace winding
{

namespace
{

/// Places of one tree. They decide how many trees can be built at a time, and nothing else.
constexpr std::size_t placesPerTree = 1 << 17;

/// More than what rounding and underflow may take from the square of a distance.
double roundedUp(double square)
{
  return (1 + 1e-9) * square + 1e-290;
}

/// The names that nanoflann looks for in what takes the results of a search.
struct Results
{
  using DistanceType = double;
  using IndexType = std::uint32_t;
  using CountType = std::size_t;

  void sort() const {}

  std::uint32_t firstPlace = 0; ///< number of the first place of the tree that is searched
};

/// The nearest places that a search has come to, except for one, in their order.
class NearestPlaces : public Results
{
public:
  /// Places farther away than a bound of squared distances are none.
  NearestPlaces(
    std::uint32_t except, std::size_t most, double bound, std::vector<Neighbor>& neighbors)
    : except_(except)
    , most_(most)
    , bound_(bound)
    , neighbors_(neighbors)
  {
    neighbors_.clear();
  }

  std::size_t size() const { return neighbors_.size(); }
  bool empty() const { return neighbors_.empty(); }
  bool full() const { return neighbors_.size() == most_; }

  /// The squared distance from which on no place counts any more. The bounds of nanoflann for its
  /// boxes are rounded, and must not leave out places that are as far as the last.
  double worstDist() const
  {
    return this->full() ? std::min(bound_, roundedUp(neighbors_.back().squaredDistance)) : bound_;
  }

  /// Returns whether the search is to go on, which it always is.
  bool addPoint(double squaredDistance, std::uint32_t placeOfTree)
  {
    const Neighbor neighbor{firstPlace + placeOfTree, squaredDistance};
    if (neighbor.place == except_ || (this->full() && !isNearer(neighbor, neighbors_.back())))
    {
      return true;
    }
    if (this->full())
    {
      neighbors_.pop_back();
    }
    neighbors_.insert(
      std::upper_bound(neighbors_.begin(), neighbors_.end(), neighbor, isNearer), neighbor);
    return true;
  }

private:
  std::uint32_t except_;
  std::size_t most_;
  double bound_;
  std::vector<Neighbor>& neighbors_;
};

/// Puts all places within a distance into a ball, up to `most` of them.
class PlacesWithin : public Results
{
public:
  PlacesWithin(double squaredRadius, std::size_t most,
    const std::vector<Eigen::Vector3d>& positions, PlacesInBall& ball)
    : squaredRadius_(squaredRadius)
    , most_(most)
    , positions_(positions)
    , ball_(ball)
  {
  }

  std::size_t size() const { return ball_.size(); }
  bool empty() const { return ball_.size() == 0; }
  bool full() const { return true; }
  double worstDist() const { return squaredRadius_; }

  bool addPoint(double, std::uint32_t placeOfTree)
  {
    const std::uint32_t place = firstPlace + placeOfTree;
    ball_.add(place, positions_[place]);
    return ball_.size() <= most_;
  }

private:
  double squaredRadius_;
  std::size_t most_;
  const std::vector<Eigen::Vector3d>& positions_;
  PlacesInBall& ball_;
};

} // namespace

/// A k-d tree of places that follow each other.
class NeighborSearch::Tree
{
public:
  Tree(const std::vector<Eigen::Vector3d>& positions, std::size_t first, std::size_t last)
    : first_(static_cast<std::uint32_t>(first))
    , positions_{positions.data() + first, last - first}
    , tree_(3, positions_, nanoflann::KDTreeSingleIndexAdaptorParams(16))
  {
    std::for_each(positions_.first, positions_.first + positions_.count,
      [this](const Eigen::Vector3d& position) { bounds_.extend(position); });
  }

  /// Adds the places around a position to the results, as far as they can count there.
  template <class Results> void find(const Eigen::Vector3d& position, Results& results) const
  {
    if (bounds_.squaredExteriorDistance(position) <= results.worstDist())
    {
      results.firstPlace = first_;
      tree_.findNeighbors(results, position.data(), {});
    }
  }

private:
  std::uint32_t first_;
  SearchedPositions positions_;
  SearchedPositions::Tree tree_;
  Eigen::AlignedBox3d bounds_;
};

struct NeighborSearch::Last::Memory
{
  PlacesInBall ball;
  std::size_t place = 0, found = 0; ///< none found: there was no search yet
  double distance = 0;              ///< distance of the farthest place found
};

NeighborSearch::Last::Last()
  : memory_(std::make_unique<Memory>())
{
}

NeighborSearch::Last::~Last() = default;

NeighborSearch::NeighborSearch(const DistinctPoints& places, Executor& executor)
  : places_(places)
  , trees_((places.size() + placesPerTree - 1) / placesPerTree)
{
  runBlocks(
    places.size(), placesPerTree,
    [&](std::size_t tree, std::size_t first, std::size_t last)
    { trees_[tree] = std::make_unique<const Tree>(places.positions(), first, last); },
    executor);
}

NeighborSearch::~NeighborSearch() = default;

void NeighborSearch::find(
  std::size_t place, std::size_t most, std::vector<Neighbor>& neighbors, Last& lastSearch) const
{
  Last::Memory& last = *lastSearch.memory_;
  neighbors.clear();
  const std::size_t count = std::min(most, places_.size() - 1);
  if (count == 0)
  {
    return;
  }
  double atMost = std::numeric_limits<double>::infinity();
  if (last.found == count)
  {
    // All that the last search found lies within its distance and the step from there to here.
    const Eigen::Vector3d step = places_.positions()[place] - places_.positions()[last.place];
    const double distance = last.distance + step.norm();
    atMost = roundedUp(distance * distance);
  }
  if (!this->findInBall(place, count, atMost, neighbors, last))
  {
    this->findInTrees(place, count, atMost, neighbors);
  }
  last.place = place;
  last.found = count;
  last.distance = std::sqrt(neighbors.back().squaredDistance);
}

/// Finds the neighbours in the ball of the last search, or in a new one where that one is too small
/// and the last search was like this one. Returns false where neither holds all of them for sure.
bool NeighborSearch::findInBall(std::size_t place, std::size_t count, double atMost,
  std::vector<Neighbor>& neighbors, Last::Memory& last) const
{
  const bool isLikeLast = last.found == count;
  const double likely = isLikeLast ? 1.2 * last.distance * last.distance : atMost;
  const auto find = [&]
  {
    return last.ball.findNearest(static_cast<std::uint32_t>(place), places_.positions()[place],
      count, likely, atMost, neighbors);
  };
  if (find())
  {
    return true;
  }
  if (!isLikeLast)
  {
    return false;
  }
  this->fill(last.ball, place, count, last.distance);
  return find();
}

/// Finds the neighbours in the trees. Its own tree comes first, since what it finds
/// spares most of the others.
void NeighborSearch::findInTrees(
  std::size_t place, std::size_t count, double atMost, std::vector<Neighbor>& neighbors) const
{
  const Eigen::Vector3d& position = places_.positions()[place];
  NearestPlaces nearest(static_cast<std::uint32_t>(place), count, atMost, neighbors);
  const Tree* const own = trees_[place / placesPerTree].get();
  own->find(position, nearest);
  for (const std::unique_ptr<const Tree>& tree : trees_)
  {
    if (tree.get() != own)
    {
      tree->find(position, nearest);
    }
  }
}

/// Makes a ball that is likely to hold the nearest neighbours of a place and of those that follow
/// it in number, if neighbours are up to a distance away.
void NeighborSearch::fill(
  PlacesInBall& ball, std::size_t place, std::size_t count, double distance) const
{
  const std::vector<Eigen::Vector3d>& positions = places_.positions();
  constexpr std::size_t mostFollowing = 16;
  Eigen::AlignedBox3d box(positions[place]);
  const std::size_t last = std::min(place + mostFollowing, positions.size());
  for (std::size_t i = place + 1; i < last; ++i)
  {
    const Eigen::AlignedBox3d larger = box.merged(Eigen::AlignedBox3d(positions[i]));
    if (larger.diagonal().norm() > 2 * distance)
    {
      break;
    }
    box = larger;
  }
  // Some neighbours are farther away than the previous place's.
  constexpr double margin = 1.15;
  const double radius = margin * distance + 0.5 * box.diagonal().norm();
  const Eigen::Vector3d center = box.center();
  const std::size_t most = 16 * count;
  PlacesWithin within(radius * radius, most, positions, ball);
  ball.start(center, radius);
  for (const std::unique_ptr<const Tree>& tree : trees_)
  {
    tree->find(center, within);
  }
  if (ball.size() > most)
  {
    ball.start(center, 0);
  }
}

} // namespace winding
