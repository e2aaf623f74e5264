// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "distance/DistanceTree.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace winding
{

/**
 * Finds which triangle or point of a source is nearest to a sample, by its number in the source.
 *
 * Several are equally near where a sample's nearest point lies on an edge or a vertex that they
 * share: distances that differ by no more than the rounding of both (roundingOfOffset()) are taken
 * for equal, and the least number counts. So the answer depends on the source and the sample only,
 * not on the tree, on other samples or on where the search begins.
 *
 * The memory is 4 bytes for each node of the tree. All queries may run on several threads at once.
 */
class NearestNumbers
{
public:
  /// Number of no item.
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// Keeps a reference.
  explicit NearestNumbers(const DistanceTree& tree);

  /// An answer to a sample.
  struct Answer
  {
    std::uint32_t number = none; ///< in the source; none where nothing is near
    std::uint32_t item = none;   ///< one that is nearest, to begin with for a sample nearby
    std::size_t place = 0;       ///< index of the place that `number` is near to
  };

  /// Finds the item that is nearest to any of `count` places in the tree's coordinates, at least
  /// one: a sample, or its images where the source has mirror images. None is nearest to places
  /// that are not finite. `guess` is an item that is likely to be near, or none.
  Answer find(const Eigen::Vector3d* places, std::size_t count, std::uint32_t guess = none) const;

  /// Sets found[i] to the number of the nearest item of sample i of a block, whose squared distance
  /// is squared[i], from items that hold all which are equally near. Both arrays have an entry for
  /// each sample and those that pad a block, and `squared` is aligned as the block is.
  void findAmong(const std::uint32_t* items, std::size_t count, const SampleBlock& samples,
    const double* squared, std::uint32_t* found) const;

private:
  double limitOf(double squared) const;
  void findLeast(const Eigen::Vector3d& place, std::uint32_t node, const Nearest& limit,
    std::uint32_t& least) const;

  const DistanceTree& tree_;
  std::vector<std::uint32_t> leastOfNodes_; ///< least number of a node's items
};

/// The place for numbers of samples' nearest items, in the samples' order.
struct NumberOutput
{
  const NearestNumbers* numbers = nullptr; ///< null where none are wanted
  std::uint32_t* to = nullptr;
};

} // namespace winding
