// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "distance/DistanceTree.h"
#include "distance/PlaceSamples.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace winding
{

/**
 * Searches for the distances of scattered samples one by one, in an order in which most follow a
 * sample nearby: what is nearest to that is a good guess, and the nodes on the way are in the
 * caches. That is faster than lists (CellDescent.h) where samples lie farther from each other than
 * items do. Each task has a search of its own.
 */
class OrderedSearch
{
public:
  /// limit: distances beyond it, in scaled coordinates, are not asked for. Keeps references. The
  /// tree has items.
  OrderedSearch(const DistanceTree& tree, double limit, const PlaceSamples& samples)
    : tree_(tree)
    , samples_(samples)
    , squaredLimit_(limit * limit)
  {
  }

  /// Writes the distances of a part's samples, and returns the parts that it left undone, since
  /// searches looked at many items, as where all of a source is equally near: lists are for them.
  std::vector<PlaceSamples::Part> run(const PlaceSamples::Part& part);

private:
  void descend(const PlaceSamples::Part& part);
  void searchEach(const PlaceSamples::Part& part);
  double searched(const Eigen::Vector3d& position, std::uint32_t& number);

  const DistanceTree& tree_;
  const PlaceSamples& samples_;
  double squaredLimit_;
  bool hasFound_ = false;
  std::uint32_t lastItem_ = 0; ///< the nearest one of the last search that found any
  std::size_t items_ = 0;      ///< that searches have looked at
  std::vector<PlaceSamples::Part> left_;
};

} // namespace winding
