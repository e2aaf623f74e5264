// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "distance/NearestLists.h"

#include <algorithm>
#include <limits>

namespace winding
{

namespace
{

/// Whether a box may hold the nearest point of a sample of the cell, by the test of the class.
/// slack: the rounding of the difference of squares.
bool canBeNearest(const NearestCell& cell, const Bounds& box, double slack)
{
  double least = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double x = cell.nearest.position[axis];
    const double low = box.min()[axis], high = box.max()[axis];
    const auto difference = [&](double q)
    {
      const double apart = std::max(0.0, std::max(low - q, q - high));
      return apart * apart - (q - x) * (q - x);
    };
    least += std::min(difference(cell.low[axis]), difference(cell.high[axis]));
  }
  return least <= slack;
}

} // namespace

NearestLists::NearestLists(const DistanceTree& tree, double limit)
  : tree_(tree)
  , limit_(limit)
  , rounding_(tree)
  , nodes_(tree.empty() ? 0 : 1, 0)
{
}

std::size_t NearestLists::itemsFrom(std::size_t firstNode) const
{
  std::size_t items = 0;
  for (std::size_t n = firstNode; n < nodes_.size(); ++n)
  {
    items += tree_.node(nodes_[n]).size();
  }
  return items;
}

void NearestLists::findNearest(NearestCell& cell, std::size_t firstNode, const SourcePoint* nearby)
{
  const Eigen::Vector3d center = cell.center();
  Nearest nearest = {std::numeric_limits<double>::infinity(), {0, 0, 0}};
  if (nearby)
  {
    cell.nearest = *nearby;
    nearest.squared = (center - nearby->position).squaredNorm();
  }
  const double known = nearest.squared;
  std::size_t closest = firstNode;
  double squared = std::numeric_limits<double>::infinity();
  for (std::size_t n = firstNode; n < nodes_.size(); ++n)
  {
    const double square = squaredDistance(tree_.box(nodes_[n]), center);
    if (square < squared)
    {
      closest = n;
      squared = square;
    }
  }
  std::size_t items = tree_.findNearest(center, nodes_[closest], nearest);
  for (std::size_t n = firstNode; n < nodes_.size(); ++n)
  {
    if (n != closest && squaredDistance(tree_.box(nodes_[n]), center) < nearest.squared)
    {
      items += tree_.findNearest(center, nodes_[n], nearest);
    }
  }
  work_ += static_cast<double>(samplesAtOnce * items);
  if (nearest.squared < known)
  {
    rounding_.setNearest(cell, nearest);
    return;
  }
  cell.setReach();
}

/// Whether all of a box is farther than the limit from all of a cell.
bool NearestLists::isBeyond(const NearestCell& cell, const Bounds& box) const
{
  const Eigen::Vector3d apart = (box.min() - cell.high).cwiseMax(cell.low - box.max()).cwiseMax(0);
  return apart.norm() > limit_;
}

void NearestLists::append(NearestCell& cell, std::size_t firstNode, const SourcePoint* nearby)
{
  const std::size_t lastNode = nodes_.size();
  if (lastNode > firstNode)
  {
    this->findNearest(cell, firstNode, nearby);
    this->appendOpened(cell, firstNode, (cell.high - cell.low).maxCoeff());
  }
}

void NearestLists::open(const NearestCell& cell, std::size_t firstNode)
{
  const std::size_t lastNode = nodes_.size();
  this->appendOpened(cell, firstNode, -1);
  const auto begin = nodes_.begin();
  nodes_.erase(
    begin + static_cast<std::ptrdiff_t>(firstNode), begin + static_cast<std::ptrdiff_t>(lastNode));
}

/// Appends what may be nearest to a sample of a cell, from the list that begins at firstNode: nodes
/// that are larger than `size` are opened.
void NearestLists::appendOpened(const NearestCell& cell, std::size_t firstNode, double size)
{
  const std::size_t lastNode = nodes_.size();
  const double slack = rounding_.slackOf(cell);
  for (std::size_t n = firstNode; n < lastNode; ++n)
  {
    opened_.assign(1, nodes_[n]);
    while (!opened_.empty())
    {
      const std::uint32_t number = opened_.back();
      opened_.pop_back();
      const Bounds& box = tree_.box(number);
      const SourceNode& node = tree_.node(number);
      const bool hasNearest = node.begin <= cell.nearest.item && cell.nearest.item < node.end;
      if ((limit_ < std::numeric_limits<double>::infinity() && this->isBeyond(cell, box)) ||
          !(hasNearest || canBeNearest(cell, box, slack)))
      {
        continue;
      }
      if (node.children > 0 && box.sizes().maxCoeff() > size)
      {
        for (std::uint32_t i = 0; i < node.children; ++i)
        {
          opened_.push_back(node.firstChild + i);
        }
        continue;
      }
      nodes_.push_back(number);
    }
  }
}

const std::vector<NearItems>& NearestLists::items(std::size_t firstNode)
{
  runs_.clear();
  for (std::size_t n = firstNode; n < nodes_.size(); ++n)
  {
    const SourceNode& node = tree_.node(nodes_[n]);
    runs_.push_back({node.begin, node.end});
  }
  return runs_;
}

} // namespace winding
