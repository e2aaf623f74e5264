#pragma once

#include "source/DistinctPoints.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace winding
{

/// A place near to another one.
struct Neighbor
{
  std::uint32_t place;
  double squaredDistance; ///< squared distance in the scaled coordinates of the places
};

/**
 * Finds the nearest other places of a place by a k-d tree (nanoflann). Building it takes O(n log n)
 * time on one thread; searches may run on several threads.
 */
class NeighborSearch
{
public:
  /// Keeps a reference to the places, which must outlive this.
  explicit NeighborSearch(const DistinctPoints& places);
  ~NeighborSearch();

  /// A search leaves this to the next one of its thread: memory, and how far it had to go, which
  /// bounds how far the next one has to if its place is near. It changes no result.
  class Last
  {
    friend class NeighborSearch;
    std::vector<std::uint32_t> places_;
    std::vector<double> squaredDistances_;
    std::size_t place_ = 0, found_ = 0; ///< none found: there was no search yet
    double distance_ = 0;               ///< distance of the farthest place found
  };

  /// Finds the `count` nearest other places, nearest first, or all others where there are fewer. If
  /// several places are equally far and not all of them are among the nearest, the tree decides
  /// which are, the same every time.
  void find(
    std::size_t place, std::size_t count, std::vector<Neighbor>& neighbors, Last& last) const;

private:
  class Tree;

  const DistinctPoints& places_;
  std::unique_ptr<const Tree> tree_;
};

} // namespace winding
