#pragma once

#include "source/DistinctPoints.h"

#include <memory>

namespace winding
{

/// A place near to another one.
struct Neighbor
{
  std::uint32_t place;
  double squaredDistance; ///< scaled as the places are
};

/**
 * The nearest other places of a place, by a k-d tree (nanoflann). O(n log n) to build, on one thread;
 * searches may run on several.
 */
class NeighborSearch
{
public:
  /// Keeps a reference to the places, which must outlive this.
  explicit NeighborSearch(const DistinctPoints& places);
  ~NeighborSearch();

  /// The `count` nearest others, nearest first, or all where there are fewer. Of equally far ones at
  /// the end, which are among them is up to the tree, and the same every time.
  void find(std::size_t place, std::size_t count, std::vector<Neighbor>& neighbors) const;

private:
  class Tree;

  const DistinctPoints& places_;
  std::unique_ptr<const Tree> tree_;
};

} // namespace winding
