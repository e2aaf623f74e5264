// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "distance/NearestCell.h"

#include <vector>

namespace winding
{

/**
 * The nodes of a DistanceTree that may be nearest to any sample of a cell, a box around samples,
 * from large cells down to small ones: the list of a cell comes from that of the cell around it.
 * The list is short because of this: let x be the point of the source nearest to the cell's centre.
 * A node can be dropped if x is nearer than it to every sample of the cell; and
 * dist²(q, box) − |q − x|² need only be looked at in the corners q of the cell, where it is
 * smallest, as for each point of the box it is linear in q. Its smallest value is the sum of the
 * smallest values along each axis. With rounding (NearestRounding) the corners still suffice, as
 * (|q − x'| + δ + ε)² is the sum of |q − x'|² and a convex function of q.
 *
 * Guaranteed: the nodes that are left hold, for each sample of the cell within the limit, the item
 * whose distance is the smallest of all items' as the loops compute it: so the least computed
 * distance of a sample does not depend on its cell.
 */
class NearestLists
{
public:
  /// limit: distances beyond it, in scaled coordinates, are not asked for; it may be infinite.
  /// Keeps a reference.
  NearestLists(const DistanceTree& tree, double limit);

  /// The number of nodes in all lists, which stand one after the other. At first there is one list,
  /// of the root alone, or of nothing if the tree is empty.
  std::size_t size() const { return nodes_.size(); }

  /// Appends the list of a cell, made from the list that begins at firstNode: that of the cell
  /// around it, or the first. Sets cell.nearest and cell.squaredReach. nearby: a point of the
  /// source, or null. Nodes larger than the cell are opened.
  void append(NearestCell& cell, std::size_t firstNode, const SourcePoint* nearby);

  /// Opens all nodes of the list of a cell, which begins at firstNode, down to leaves.
  void open(const NearestCell& cell, std::size_t firstNode);

  /// Removes the lists from a place on.
  void removeFrom(std::size_t firstNode) { nodes_.resize(firstNode); }

  /// The number of items in the nodes of the list that begins at firstNode.
  std::size_t itemsFrom(std::size_t firstNode) const;

  /// The items, as runs, of the nodes of the list that begins at firstNode. There are none only if
  /// all of the source is beyond the limit.
  const std::vector<NearItems>& items(std::size_t firstNode);

  /// The samples times items that have been looked at.
  double work() const { return work_; }

private:
  void findNearest(NearestCell& cell, std::size_t firstNode, const SourcePoint* nearby);
  bool isBeyond(const NearestCell& cell, const Bounds& box) const;
  void appendOpened(const NearestCell& cell, std::size_t firstNode, double size);

  const DistanceTree& tree_;
  const double limit_;
  const NearestRounding rounding_;
  double work_ = 0;
  std::vector<std::uint32_t> nodes_;
  std::vector<std::uint32_t> opened_;
  std::vector<NearItems> runs_;
};

} // namespace winding
