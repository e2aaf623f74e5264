#pragma once

#include "distance/DistanceTree.h"

#include <vector>

namespace winding
{

/**
 * The nodes and items of a DistanceTree that may be nearest to any sample of a cell, a box around
 * samples, from large cells down to small ones: those of a cell come from those of the cell that it
 * lies in. The list is short because of this: let x be the point of the source nearest to the
 * cell's centre. A node can be dropped if x is nearer than it to every sample of the cell; and
 * dist²(q, box) − |q − x|² need only be looked at in the corners q of the cell, where it is
 * smallest, as for each point of the box it is linear in q. Its smallest value is the sum of the
 * smallest values along each axis.
 *
 * Rounding turns x into a point x' within δ of the source (roundingOfOffset, and the rounding of
 * its coordinates). So the source is no farther from q than |q − x'| + δ. A node is dropped only
 * where it is farther than that from all q, and by ε more, the rounding of all distances that are
 * compared. The corners still suffice, as (|q − x'| + δ + ε)² is the sum of |q − x'|² and a convex
 * function of q. δ and ε are relative to the whole source, not to the cell, which may lie beside a
 * vertex and be as small.
 *
 * Guaranteed: the items that are left hold, for each sample of the cell within the limit, the one
 * whose distance is the smallest of all items' as the loops compute it: so the least computed
 * distance of a sample does not depend on its cell.
 */
class NearestLists
{
public:
  /// limit: distances beyond it, in scaled coordinates, are not asked for; it may be infinite.
  /// Keeps a reference.
  NearestLists(const DistanceTree& tree, double limit);

  /// A point of the source.
  struct SourcePoint
  {
    Eigen::Vector3d position;
    double rounding;    ///< how far from the source rounding may have put it
    std::uint32_t item; ///< number of the item that it lies on
  };

  /// A box of samples in scaled coordinates, and the source's point nearest to its centre.
  struct Cell
  {
    Eigen::Vector3d low, high;
    SourcePoint nearest;
    double squaredReach; ///< at least the square of the distance of `nearest` from any sample

    Eigen::Vector3d center() const { return low + 0.5 * (high - low); }
  };

  /// The number of nodes in all lists, which stand one after the other. At first there is one list,
  /// of the root alone, or of nothing if the tree is empty.
  std::size_t size() const { return nodes_.size(); }

  /// Appends the list of a cell, made from the list that begins at firstNode: that of the cell
  /// around it, or the first. Sets cell.nearest and cell.squaredReach. nearby: a point of the
  /// source, or null. Nodes larger than the cell are opened; all down to leaves if areLeaves.
  void append(Cell& cell, std::size_t firstNode, const SourcePoint* nearby, bool areLeaves);

  /// Removes the lists from a place on.
  void removeFrom(std::size_t firstNode) { nodes_.resize(firstNode); }

  /// The number of items in the list of leaves that begins at firstNode.
  std::size_t itemsFrom(std::size_t firstNode) const;

  /// The items, as runs, of the list of leaves that begins at firstNode.
  const std::vector<NearItems>& items(std::size_t firstNode);

  /// The items of the list that may be nearest to a sample of its cell. There are none only if all
  /// of the source is beyond the limit.
  const std::vector<NearItems>& nearItems(const Cell& cell, std::size_t firstNode);

  /// The samples times items that have been looked at so far.
  double work() const { return work_; }

private:
  void findNearest(Cell& cell, std::size_t firstNode, const SourcePoint* nearby);
  double roundingOf(const Cell& cell) const;
  bool isBeyond(const Cell& cell, const Bounds& box) const;

  const DistanceTree& tree_;
  const double limit_;
  double sourceSize_ = 0;   ///< no distance of two points of the source is larger
  double farthest_ = 0;     ///< no coordinate of the source is larger
  double squareOfThin_ = 0; ///< by so much a thin triangle's computed square may be too large
  double work_ = 0;
  std::vector<std::uint32_t> nodes_;
  std::vector<std::uint32_t> opened_;
  std::vector<NearItems> runs_, kept_;
};

} // namespace winding
