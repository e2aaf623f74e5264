// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "distance/DistanceTree.h"

#include "source/CoordinateOrder.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <cmath>

namespace winding
{

namespace
{

/// Leaves of these sizes are best by measurement: leaves of 1 and 2 items take up to twice as long,
/// and leaves of twice as many items about as long.
constexpr std::size_t trianglesPerLeaf = 4, pointsPerLeaf = 16;

std::vector<Eigen::Vector3d> centersOf(const Surface& surface, double scale, Executor& executor)
{
  std::vector<Eigen::Vector3d> centers(surface.triangles.size());
  forEachItem(
    centers.size(),
    [&](std::size_t i)
    {
      const Triangle t = lowestFirst(surface.vertices, surface.triangles[i]);
      centers[i] = scale / 3 * surface.vertices[t[0]] +
                   (scale / 3 * surface.vertices[t[1]] + scale / 3 * surface.vertices[t[2]]);
    },
    executor);
  return centers;
}

std::vector<Eigen::Vector3d> centersOf(const PointCloud& cloud, double scale, Executor& executor)
{
  std::vector<Eigen::Vector3d> centers(cloud.positions.size());
  forEachItem(
    centers.size(), [&](std::size_t i) { centers[i] = scale * cloud.positions[i]; }, executor);
  return centers;
}

} // namespace

DistanceTree::DistanceTree(const Surface& surface, Executor& executor)
  : scale_(unitScale(surface.bounds))
  , tree_(centersOf(surface, scale_, executor), trianglesPerLeaf, executor,
      [&surface](std::uint32_t a, std::uint32_t b)
      {
        const std::vector<Eigen::Vector3d>& vertices = surface.vertices;
        return compareTriangles(vertices, lowestFirst(vertices, surface.triangles[a]),
                 lowestFirst(vertices, surface.triangles[b])) < 0;
      })
  , triangles_(surface.triangles.size())
{
  this->makeItemsAndBoxes(
    [&](std::uint32_t place)
    {
      const Triangle t = lowestFirst(surface.vertices, surface.triangles[tree_.order()[place]]);
      const Eigen::Vector3d a = scale_ * surface.vertices[t[0]],
                            b = scale_ * surface.vertices[t[1]],
                            c = scale_ * surface.vertices[t[2]];
      triangles_[place] = nearTriangle(a, b, c);
      return Bounds(a).extend(b).extend(c);
    },
    executor);
}

DistanceTree::DistanceTree(const PointCloud& cloud, Executor& executor)
  : scale_(unitScale(cloud.bounds))
  , tree_(centersOf(cloud, scale_, executor), pointsPerLeaf, executor)
  , points_(cloud.positions.size())
{
  this->makeItemsAndBoxes(
    [&](std::uint32_t place)
    {
      const Eigen::Vector3d position = scale_ * cloud.positions[tree_.order()[place]];
      points_[place] = nearPoint(position);
      return Bounds(position);
    },
    executor);
}

std::size_t DistanceTree::bytesFor(bool areTriangles, std::size_t primitives)
{
  // There are about one and a half nodes for every leaf, and leaves are half full.
  const std::size_t perItem = (areTriangles ? sizeof(NearTriangle) : sizeof(NearPoint)) + 4;
  const std::size_t perLeaf = 3 * (sizeof(SourceNode) + sizeof(Bounds)) / 2;
  const std::size_t leafSize = areTriangles ? trianglesPerLeaf : pointsPerLeaf;
  return primitives * (perItem + 2 * perLeaf / leafSize);
}

/// Makes what stands in leaves, each item once, and the boxes of nodes: depth by depth from the
/// deepest up, as a node's box is made from its children's. make(place) makes an item, and returns
/// its box.
template <class Make> void DistanceTree::makeItemsAndBoxes(const Make& make, Executor& executor)
{
  const std::vector<SourceNode>& nodes = tree_.nodes();
  boxes_.resize(nodes.size());
  const std::vector<std::size_t>& starts = tree_.depthStarts();
  for (std::size_t depth = starts.size() - 1; depth-- > 0;)
  {
    constexpr std::size_t nodesPerBlock = 1024;
    runBlocks(
      starts[depth + 1] - starts[depth], nodesPerBlock,
      [&](std::size_t, std::size_t first, std::size_t last)
      {
        for (std::size_t n = starts[depth] + first; n < starts[depth] + last; ++n)
        {
          const SourceNode& node = nodes[n];
          for (std::uint32_t i = 0; i < node.children; ++i)
          {
            boxes_[n].extend(boxes_[node.firstChild + i]);
          }
          for (std::uint32_t i = node.begin; node.children == 0 && i < node.end; ++i)
          {
            boxes_[n].extend(make(i));
          }
        }
      },
      executor);
  }
  size_ = boxes_.empty() ? 0 : boxes_[0].sizes().norm();
}

std::size_t DistanceTree::findNearest(
  const Eigen::Vector3d& sample, std::uint32_t number, Nearest& nearest) const
{
  const SourceNode& top = this->node(number);
  if (top.children == 0)
  {
    this->findAmong(sample, {top.begin, top.end}, nearest);
    return top.end - top.begin;
  }
  // The child with the nearest box comes first, since it lowers the limit for the others.
  struct Child
  {
    double squared;
    std::uint32_t number;
  };
  Child children[4];
  for (std::uint32_t i = 0; i < top.children; ++i)
  {
    Child child = {squaredDistance(this->box(top.firstChild + i), sample), top.firstChild + i};
    std::uint32_t place = i;
    for (; place > 0 && child.squared < children[place - 1].squared; --place)
    {
      children[place] = children[place - 1];
    }
    children[place] = child;
  }
  std::size_t items = 0;
  for (std::uint32_t i = 0; i < top.children && this->mayHoldNearer(children[i].squared, nearest);
       ++i)
  {
    items += this->findNearest(sample, children[i].number, nearest);
  }
  return items;
}

void DistanceTree::compare(
  const Eigen::Vector3d& sample, std::uint32_t item, Nearest& nearest) const
{
  this->findAmong(sample, {item, item + 1}, nearest);
}

void DistanceTree::findAmong(
  const Eigen::Vector3d& sample, const NearItems& items, Nearest& nearest) const
{
  if (points_.empty())
  {
    winding::findNearest(triangles_.data(), items, sample.data(), nearest);
  }
  else
  {
    winding::findNearest(points_.data(), items, sample.data(), nearest);
  }
}

bool DistanceTree::mayHoldNearer(double squared, const Nearest& nearest) const
{
  if (squared < nearest.squared)
  {
    return true;
  }
  const double distance = std::sqrt(nearest.squared);
  const double reach = distance + 2 * roundingOfOffset(distance, size_);
  return squared <= reach * reach;
}

void DistanceTree::assign(const std::vector<NearItems>& runs, Candidates& to) const
{
  if (points_.empty())
  {
    to.assign(triangles_.data(), runs);
  }
  else
  {
    to.assign(points_.data(), runs);
  }
}

void DistanceTree::lowerSquaredDistances(
  const std::uint32_t* items, std::size_t count, const SampleBlock& samples, double* squared) const
{
  if (points_.empty())
  {
    winding::lowerSquaredDistances(triangles_.data(), items, count, samples, squared);
  }
  else
  {
    winding::lowerSquaredDistances(points_.data(), items, count, samples, squared);
  }
}

void DistanceTree::findNearestOfEach(
  const std::uint32_t* items, std::size_t count, const SampleBlock& samples, Nearest* nearest) const
{
  if (points_.empty())
  {
    winding::findNearestOfEach(triangles_.data(), items, count, samples, nearest);
  }
  else
  {
    winding::findNearestOfEach(points_.data(), items, count, samples, nearest);
  }
}

void DistanceTree::lowerNumbers(const std::uint32_t* items, std::size_t count,
  const SampleBlock& samples, const double* squaredLimits, double* least) const
{
  const std::uint32_t* const names = tree_.order().data();
  if (points_.empty())
  {
    lowerNames(triangles_.data(), items, count, names, samples, squaredLimits, least);
  }
  else
  {
    lowerNames(points_.data(), items, count, names, samples, squaredLimits, least);
  }
}

bool DistanceTree::isNearer(
  std::uint32_t triangle, const SampleBlock& samples, const double* limits) const
{
  return winding::isNearer(triangles_[triangle], samples, limits);
}

} // namespace winding
