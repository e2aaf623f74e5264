#include "cloud/NeighborSearch.h"

#include <nanoflann.hpp>

#include <algorithm>

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

} // namespace

class NeighborSearch::Tree
{
public:
  explicit Tree(const std::vector<Eigen::Vector3d>& positions)
    : positions_{positions}
    , tree_(3, positions_, nanoflann::KDTreeSingleIndexAdaptorParams(16))
  {
  }

  void find(const Eigen::Vector3d& position, std::size_t count, std::uint32_t* places,
    double* squaredDistances) const
  {
    tree_.knnSearch(position.data(), count, places, squaredDistances);
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
  std::size_t place, std::size_t count, std::vector<Neighbor>& neighbors) const
{
  neighbors.clear();
  // The tree finds the place itself, too.
  const std::size_t found = std::min(count, places_.size() - 1) + 1;
  std::vector<std::uint32_t> places(found);
  std::vector<double> squaredDistances(found);
  tree_->find(places_.positions()[place], found, places.data(), squaredDistances.data());
  for (std::size_t i = 0; i < found; ++i)
  {
    // The place itself need not come first where squares of distances underflow, and need not come
    // at all.
    if (places[i] != place && neighbors.size() + 1 < found)
    {
      neighbors.push_back({places[i], squaredDistances[i]});
    }
  }
}

} // namespace winding
