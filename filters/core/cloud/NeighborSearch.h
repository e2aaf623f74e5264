#pragma once

#include "source/DistinctPoints.h"

#include <memory>

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

  /// Finds the `count` nearest other places, nearest first, or all others where there are fewer. If
  /// several places are equally far and not all of them are among the nearest, the tree decides
  /// which are, the same every time.
  void find(std::size_t place, std::size_t count, std::vector<Neighbor>& neighbors) const;

private:
  class Tree;

  const DistinctPoints& places_;
  std::unique_ptr<const Tree> tree_;
};

} // namespace winding
