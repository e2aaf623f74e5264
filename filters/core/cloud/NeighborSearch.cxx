#include "cloud/NeighborSearch.h"

#include <nanoflann.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace winding
{

namespace
{

/// The interface through which nanoflann reads the positions of places.
struct Positions
{
  const std::vector<Eigen::Vector3d>& positions;

  std::size_t kdtree_get_point_count() const { return positions.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return positions[i][axis]; }
  template <class Box> bool kdtree_get_bbox(Box&) const { return false; }
};

using Metric = nanoflann::L2_Simple_Adaptor<double, Positions, double, std::uint32_t>;

/// The nearest places that a search has come to, as nanoflann asks for them: those of equal
/// distances stay in the order in which it came to them. Places farther away than a bound are none.
class NearestPlaces
{
public:
  ///@{
  /// Names that nanoflann looks for.
  using DistanceType = double;
  using IndexType = std::uint32_t;
  using CountType = std::size_t;
  ///@}

  NearestPlaces(std::size_t most, double bound, std::uint32_t* places, double* squaredDistances)
    : most_(most)
    , bound_(bound)
    , places_(places)
    , squaredDistances_(squaredDistances)
  {
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  bool full() const { return size_ == most_; }
  void sort() const {} // they are

  /// The square of the distance from which on no place counts any more.
  double worstDist() const
  {
    return this->full() ? std::min(bound_, squaredDistances_[most_ - 1]) : bound_;
  }

  /// Returns whether the search is to go on, which it always is.
  bool addPoint(double squaredDistance, std::uint32_t place)
  {
    if (!(squaredDistance < this->worstDist()))
    {
      return true;
    }
    size_ += this->full() ? 0 : 1;
    std::size_t i = size_ - 1;
    for (; i > 0 && squaredDistances_[i - 1] > squaredDistance; --i)
    {
      squaredDistances_[i] = squaredDistances_[i - 1];
      places_[i] = places_[i - 1];
    }
    squaredDistances_[i] = squaredDistance;
    places_[i] = place;
    return true;
  }

private:
  std::size_t most_, size_ = 0;
  double bound_;
  std::uint32_t* places_;
  double* squaredDistances_;
};

} // namespace

class NeighborSearch::Tree
{
public:
  explicit Tree(const std::vector<Eigen::Vector3d>& positions)
    : positions_{positions}
    , tree_(3, positions_, nanoflann::KDTreeSingleIndexAdaptorParams(16))
  {
  }

  void find(const Eigen::Vector3d& position, NearestPlaces& nearest) const
  {
    tree_.findNeighbors(nearest, position.data(), {});
  }

private:
  Positions positions_;
  nanoflann::KDTreeSingleIndexAdaptor<Metric, Positions, 3, std::uint32_t> tree_;
};

NeighborSearch::NeighborSearch(const DistinctPoints& places)
  : places_(places)
  , tree_(std::make_unique<Tree>(places.positions()))
{
}

NeighborSearch::~NeighborSearch() = default;

void NeighborSearch::find(
  std::size_t place, std::size_t count, std::vector<Neighbor>& neighbors, Last& last) const
{
  neighbors.clear();
  // The tree finds the place itself, too.
  const std::size_t found = std::min(count, places_.size() - 1) + 1;
  const Eigen::Vector3d& position = places_.positions()[place];
  double bound = std::numeric_limits<double>::infinity();
  if (last.found_ == found)
  {
    // All that the last search found lies within its distance and the step from there to here. The
    // factor and the term are more than what rounding and underflow may take from squares.
    const double most = last.distance_ + (position - places_.positions()[last.place_]).norm();
    bound = (1 + 1e-9) * most * most + 1e-290;
  }
  last.places_.resize(found);
  last.squaredDistances_.resize(found);
  NearestPlaces nearest(found, bound, last.places_.data(), last.squaredDistances_.data());
  tree_->find(position, nearest);
  last.place_ = place;
  last.found_ = found;
  last.distance_ = std::sqrt(last.squaredDistances_.back());
  for (std::size_t i = 0; i < found; ++i)
  {
    // The place itself need not come first where squares of distances underflow, and need not come
    // at all.
    if (last.places_[i] != place && neighbors.size() + 1 < found)
    {
      neighbors.push_back({last.places_[i], last.squaredDistances_[i]});
    }
  }
}

} // namespace winding
