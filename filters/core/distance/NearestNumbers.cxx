// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "distance/NearestNumbers.h"

#include <algorithm>
#include <cmath>

namespace winding
{

NearestNumbers::NearestNumbers(const DistanceTree& tree)
  : tree_(tree)
  , leastOfNodes_(tree.nodes(), none)
{
  for (std::size_t n = leastOfNodes_.size(); n-- > 0;)
  {
    const SourceNode& node = tree.node(static_cast<std::uint32_t>(n));
    std::uint32_t& least = leastOfNodes_[n];
    for (std::uint32_t i = 0; i < node.children; ++i)
    {
      least = std::min(least, leastOfNodes_[node.firstChild + i]);
    }
    for (std::uint32_t item = node.begin; node.children == 0 && item < node.end; ++item)
    {
      least = std::min(least, tree.numberOf(item));
    }
  }
}

NearestNumbers::Answer NearestNumbers::find(
  const Eigen::Vector3d* places, std::size_t count, std::uint32_t guess) const
{
  Answer answer;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Nearest nearest = {infinite, {0, 0, 0}, none};
  const bool isAnywhere =
    std::all_of(places, places + count, [](const Eigen::Vector3d& p) { return p.allFinite(); });
  for (std::size_t n = 0; n < count && isAnywhere && !tree_.empty(); ++n)
  {
    if (guess != none && n == 0)
    {
      tree_.compare(places[n], guess, nearest);
    }
    tree_.findNearest(places[n], 0, nearest);
  }
  answer.item = nearest.item;
  if (nearest.item == none)
  {
    return answer;
  }
  const Nearest limit = {this->limitOf(nearest.squared), {0, 0, 0}, none};
  for (std::size_t n = 0; n < count; ++n)
  {
    const std::uint32_t before = answer.number;
    this->findLeast(places[n], 0, limit, answer.number);
    answer.place = answer.number < before ? n : answer.place;
  }
  return answer;
}

/// Returns what squared distances are below that are as near as one.
double NearestNumbers::limitOf(double squared) const
{
  const double distance = std::sqrt(squared);
  const double reach = distance + 2 * roundingOfOffset(distance, tree_.size());
  // An item at distance 0 is below the limit, too.
  return std::nextafter(reach * reach, std::numeric_limits<double>::infinity());
}

void NearestNumbers::findAmong(const std::uint32_t* items, std::size_t count,
  const SampleBlock& samples, const double* squared, std::uint32_t* found) const
{
  alignas(64) double limits[SampleBlock::capacity];
  alignas(64) double least[SampleBlock::capacity];
  const std::size_t padded = (samples.count + samplesAtOnce - 1) / samplesAtOnce * samplesAtOnce;
  for (std::size_t n = 0; n < padded; ++n)
  {
    limits[n] = this->limitOf(squared[n]);
    least[n] = none;
  }
  tree_.lowerNumbers(items, count, samples, limits, least);
  std::transform(least, least + samples.count, found,
    [](double number) { return static_cast<std::uint32_t>(number); });
}

/// Lowers `least` to the least number of a node's items within a limit.
void NearestNumbers::findLeast(const Eigen::Vector3d& place, std::uint32_t number,
  const Nearest& limit, std::uint32_t& least) const
{
  if (leastOfNodes_[number] >= least ||
      !tree_.mayHoldNearer(squaredDistance(tree_.box(number), place), limit))
  {
    return;
  }
  const SourceNode& node = tree_.node(number);
  for (std::uint32_t item = node.begin; node.children == 0 && item < node.end; ++item)
  {
    Nearest nearest = limit;
    if (tree_.numberOf(item) < least)
    {
      tree_.compare(place, item, nearest);
    }
    least = nearest.squared < limit.squared ? tree_.numberOf(item) : least;
  }
  // The child with the least number comes first, since that leaves most others out.
  std::uint32_t children[4];
  for (std::uint32_t i = 0; i < node.children; ++i)
  {
    const std::uint32_t child = node.firstChild + i;
    std::uint32_t at = i;
    for (; at > 0 && leastOfNodes_[child] < leastOfNodes_[children[at - 1]]; --at)
    {
      children[at] = children[at - 1];
    }
    children[at] = child;
  }
  for (std::uint32_t i = 0; i < node.children; ++i)
  {
    this->findLeast(place, children[i], limit, least);
  }
}

} // namespace winding
