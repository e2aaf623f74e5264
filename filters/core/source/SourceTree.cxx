// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "source/SourceTree.h"

#include "base/UninitializedVector.h"
#include "source/CompareCoordinates.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace winding
{

namespace
{

struct Item
{
  Eigen::Vector3d center;
  std::uint32_t number;
};

/// Cuts items in two in the middle of the longest side of their tight box. Returns the first item
/// of the second half; null if all are equal.
Item* cutInTwo(Item* first, Item* last)
{
  Eigen::AlignedBox3d box;
  for (const Item* item = first; item != last; ++item)
  {
    box.extend(item->center);
  }
  Eigen::Index axis;
  if (box.isEmpty() || !(box.sizes().maxCoeff(&axis) > 0))
  {
    return nullptr;
  }
  const double low = box.min()[axis], high = box.max()[axis];
  // The middle may round to `low` where no number lies in between; the cut is at `high` then.
  double middle = low + (high - low) / 2;
  middle = middle > low ? middle : high;
  return std::partition(
    first, last, [axis, middle](const Item& item) { return item.center[axis] < middle; });
}

/// Cuts items into up to four runs, sets the limits between them and returns the number of runs; 0
/// if all items are equal.
std::size_t cutInFour(Item* first, Item* last, std::size_t leafSize, std::array<Item*, 5>& limits)
{
  limits[0] = first;
  Item* const middle = cutInTwo(first, last);
  if (!middle)
  {
    return 0;
  }
  std::size_t runs = 0;
  for (const auto& [begin, end] : {std::pair(first, middle), std::pair(middle, last)})
  {
    const bool isSmall = static_cast<std::size_t>(end - begin) <= leafSize;
    if (Item* const quarter = isSmall ? nullptr : cutInTwo(begin, end))
    {
      limits[++runs] = quarter;
    }
    limits[++runs] = end;
  }
  return runs;
}

/// Sorts the items of a leaf.
void sortLeaf(Item* first, Item* last, const SourceTree::IsBefore& isBefore)
{
  std::sort(first, last,
    [&isBefore](const Item& a, const Item& b)
    {
      const int byCenter = compareCoordinates(a.center, b.center);
      return byCenter != 0 ? byCenter < 0 : isBefore(a.number, b.number);
    });
}

} // namespace

SourceTree::SourceTree(const std::vector<Eigen::Vector3d>& centers, std::size_t leafSize,
  Executor& executor, const IsBefore& isBefore)
{
  UninitializedVector<Item> items(centers.size());
  forEachItem(
    centers.size(),
    [&](std::size_t i) {
      items[i] = {centers[i], static_cast<std::uint32_t>(i)};
    },
    executor);
  depthStarts_.push_back(0);
  if (!centers.empty())
  {
    nodes_.push_back({0, static_cast<std::uint32_t>(centers.size()), 0, 0});
  }
  std::vector<std::array<Item*, 5>> limits;
  while (depthStarts_.back() < nodes_.size())
  {
    const std::size_t first = depthStarts_.back();
    const std::size_t count = nodes_.size() - first;
    depthStarts_.push_back(nodes_.size());
    limits.resize(count);
    // Blocks have about equal work: there are many small nodes at large depths.
    constexpr std::size_t nodesPerBlock = 64;
    const std::size_t perBlock = count < 8 * nodesPerBlock ? 1 : nodesPerBlock;
    runBlocks(
      count, perBlock,
      [&](std::size_t, std::size_t firstOfBlock, std::size_t lastOfBlock)
      {
        for (std::size_t i = firstOfBlock; i < lastOfBlock; ++i)
        {
          SourceNode& node = nodes_[first + i];
          Item* const begin = items.data() + node.begin;
          Item* const end = items.data() + node.end;
          if (node.size() > leafSize)
          {
            node.children = static_cast<std::uint32_t>(cutInFour(begin, end, leafSize, limits[i]));
          }
          if (node.children == 0)
          {
            sortLeaf(begin, end, isBefore);
          }
        }
      },
      executor);
    for (std::size_t i = 0; i < count; ++i)
    {
      nodes_[first + i].firstChild = static_cast<std::uint32_t>(nodes_.size());
      for (std::uint32_t child = 0; child < nodes_[first + i].children; ++child)
      {
        nodes_.push_back({static_cast<std::uint32_t>(limits[i][child] - items.data()),
          static_cast<std::uint32_t>(limits[i][child + 1] - items.data()), 0, 0});
      }
    }
  }
  order_.resize(centers.size());
  forEachItem(
    centers.size(), [&](std::size_t i) { order_[i] = items[i].number; }, executor);
}

} // namespace winding
