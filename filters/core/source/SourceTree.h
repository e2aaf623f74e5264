// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <vector>

namespace winding
{

/// A node of a SourceTree: a run of items in the tree's order.
struct SourceNode
{
  std::uint32_t begin, end;
  std::uint32_t firstChild; ///< number of the first child; children stand one after the other
  std::uint32_t children;   ///< 0 for a leaf

  std::uint32_t size() const { return end - begin; }
};

/**
 * A hierarchy of items by their centres. A node is cut in the middle of the longest side of its
 * tight box, and both halves once more in the same way, so that it has up to four children: as many
 * as a flat piece of surface needs for children of half its size.
 *
 * Tight boxes make the tree blind to scale: any number of sources any distance apart costs a few
 * levels, and n equal items are one leaf. Guaranteed: (1) the tree is the same for any executor and
 * number of threads; (2) every item lies in exactly one leaf, and a node's items are all of its
 * children; (3) leaves hold up to `leafSize` items, and more only if their centres are equal;
 * (4) parents stand before their children, and nodes of one depth stand together; (5) the items of
 * a leaf stand in the order of their centres (CompareCoordinates.h), and items with equal centres
 * in an order of the caller's or, without one, of their numbers. So the tree depends on the set of
 * centres, not on the order in which they are given, if the caller tells apart what differs.
 *
 * Building takes a time of items × depth and 32 bytes per item.
 */
class SourceTree
{
public:
  /// Whether an item stands before another one with an equal centre; given their numbers.
  using IsBefore = std::function<bool(std::uint32_t, std::uint32_t)>;

  /// Up to 2³² − 1 centres, all finite. isBefore may be called from several threads. Throws
  /// Interrupted when the executor is.
  SourceTree(const std::vector<Eigen::Vector3d>& centers, std::size_t leafSize, Executor& executor,
    const IsBefore& isBefore = std::less<std::uint32_t>());

  /// The nodes; node 0 is the root. There are none without items.
  const std::vector<SourceNode>& nodes() const { return nodes_; }

  /// The nodes of each depth: nodes depthStarts()[d] … depthStarts()[d + 1] − 1 have depth d.
  const std::vector<std::size_t>& depthStarts() const { return depthStarts_; }

  /// The item at each place of the tree's order.
  const std::vector<std::uint32_t>& order() const { return order_; }

private:
  std::vector<SourceNode> nodes_;
  std::vector<std::size_t> depthStarts_;
  std::vector<std::uint32_t> order_;
};

} // namespace winding
