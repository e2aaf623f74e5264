#include "distance/NearestLists.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace winding
{

namespace
{

/// An item is compared with this many samples at once; with fewer samples it takes as long.
constexpr double samplesAtOnce = 8;

/// A triangle whose sides stand for its inside (NearestKernels.h) is thinner than this times the
/// source: the others have weights that are right to as much.
constexpr double thin = 0x1p-40;

/// Whether a box may hold the nearest point of a sample of the cell, by the test of the class.
/// slack: the rounding of the difference of squares.
bool canBeNearest(const NearestLists::Cell& cell, const Bounds& box, double slack)
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
  , nodes_(tree.empty() ? 0 : 1, 0)
{
  if (!tree.empty())
  {
    const Bounds& box = tree.box(0);
    sourceSize_ = box.sizes().norm();
    farthest_ = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
    squareOfThin_ = (thin * sourceSize_) * (thin * sourceSize_);
  }
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

void NearestLists::findNearest(Cell& cell, std::size_t firstNode, const SourcePoint* nearby)
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
  work_ += samplesAtOnce * static_cast<double>(items);
  if (nearest.squared < known)
  {
    cell.nearest.position = center - Eigen::Map<const Eigen::Vector3d>(nearest.offset);
    // Three coordinates are rounded by half an epsilon each.
    cell.nearest.rounding = roundingOfOffset(std::sqrt(nearest.squared), sourceSize_) +
                            std::numeric_limits<double>::epsilon() * farthest_;
    cell.nearest.item = nearest.item;
  }
  cell.squaredReach = (cell.low - cell.nearest.position).squaredNorm() +
                      (cell.high - cell.nearest.position).squaredNorm();
}

/// The sum δ + ε of the class: the rounding of the nearest point and of the distances from it that
/// are compared.
double NearestLists::roundingOf(const Cell& cell) const
{
  // Four distances are rounded: those of the nearest item and of another one, each from a sample
  // and from a corner of the cell.
  return cell.nearest.rounding + 4 * roundingOfOffset(std::sqrt(cell.squaredReach), sourceSize_);
}

/// Whether all of a box is farther than the limit from all of a cell.
bool NearestLists::isBeyond(const Cell& cell, const Bounds& box) const
{
  const Eigen::Vector3d apart = (box.min() - cell.high).cwiseMax(cell.low - box.max()).cwiseMax(0);
  return apart.norm() > limit_;
}

void NearestLists::append(
  Cell& cell, std::size_t firstNode, const SourcePoint* nearby, bool areLeaves)
{
  const std::size_t lastNode = nodes_.size();
  if (lastNode == firstNode)
  {
    return;
  }
  this->findNearest(cell, firstNode, nearby);
  const double side = (cell.high - cell.low).maxCoeff();
  const double rounding = this->roundingOf(cell);
  const double slack = (2 * std::sqrt(cell.squaredReach) + rounding) * rounding +
                       32 * std::numeric_limits<double>::epsilon() * cell.squaredReach +
                       squareOfThin_;
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
      if (node.children > 0 && (areLeaves || box.sizes().maxCoeff() > side))
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

/// Makes the test of canBeNearest() with the distances of the items instead of boxes.
const std::vector<NearItems>& NearestLists::nearItems(const Cell& cell, std::size_t firstNode)
{
  kept_.clear();
  if (this->items(firstNode).empty())
  {
    return kept_;
  }
  const double rounding = this->roundingOf(cell);
  SampleBlock corners;
  corners.count = 8;
  alignas(64) double squared[8];
  for (std::size_t i = 0; i < 8; ++i)
  {
    const Eigen::Vector3d corner((i & 1 ? cell.high : cell.low)[0],
      (i & 2 ? cell.high : cell.low)[1], (i & 4 ? cell.high : cell.low)[2]);
    corners.set(i, corner);
    const double distance = (corner - cell.nearest.position).norm() + rounding;
    squared[i] = distance * distance + squareOfThin_;
  }
  tree_.keepNearer(runs_, corners, squared, kept_);
  for (const NearItems& run : runs_)
  {
    work_ += samplesAtOnce * (run.last - run.first);
  }
  const std::uint32_t item = cell.nearest.item;
  if (std::none_of(kept_.begin(), kept_.end(),
        [item](const NearItems& run) { return run.first <= item && item < run.last; }))
  {
    kept_.push_back({item, item + 1});
  }
  return kept_;
}

} // namespace winding
