// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rays/CrossingTree.h"

#include "rays/RayTriangle.h"
#include "source/UnitScale.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace winding
{

namespace
{

/// Returns the numbers of the triangles whose parts have bounds.
std::vector<std::int32_t> trianglesOfParts(
  const std::vector<std::int32_t>& partOfTriangle, const std::vector<Bounds>& boundsOfPart)
{
  std::vector<std::int32_t> triangles;
  for (std::size_t i = 0; i < partOfTriangle.size(); ++i)
  {
    if (!boundsOfPart[partOfTriangle[i]].isEmpty())
    {
      triangles.push_back(static_cast<std::int32_t>(i));
    }
  }
  return triangles;
}

} // namespace

CrossingTree::CrossingTree(const Surface& surface, const std::vector<std::int32_t>& partOfTriangle,
  const std::vector<Bounds>& boundsOfPart)
  : CrossingTree(
      surface, partOfTriangle, boundsOfPart, trianglesOfParts(partOfTriangle, boundsOfPart))
{
}

CrossingTree::CrossingTree(const Surface& surface, const std::vector<std::int32_t>& partOfTriangle,
  const std::vector<Bounds>& boundsOfPart, std::vector<std::int32_t> triangles)
  : surface_(surface)
  , partOfTriangle_(partOfTriangle)
  , boundsOfPart_(boundsOfPart)
  , scale_(unitScale(surface.bounds))
  , triangles_(std::move(triangles))
{
  if (!triangles_.empty())
  {
    this->makeNode(0, static_cast<std::int32_t>(triangles_.size()));
  }
}

std::int32_t CrossingTree::makeNode(std::int32_t begin, std::int32_t end)
{
  Bounds bounds;
  double startX = std::numeric_limits<double>::infinity();
  for (std::int32_t i = begin; i < end; ++i)
  {
    startX = std::min(startX, boundsOfPart_[partOfTriangle_[triangles_[i]]].min()[0]);
    for (const std::int32_t vertex : surface_.triangles[triangles_[i]])
    {
      bounds.extend(surface_.vertices[vertex]);
    }
  }
  const auto number = static_cast<std::int32_t>(nodes_.size());
  nodes_.push_back({startX, bounds.max()[0], bounds.min()[1], bounds.max()[1], bounds.min()[2],
    bounds.max()[2], begin, end, -1});
  constexpr std::int32_t perLeaf = 8;
  if (end - begin <= perLeaf)
  {
    return number;
  }
  const int axis = bounds.sizes()[1] >= bounds.sizes()[2] ? 1 : 2;
  // Triangles are sorted by their centres, and those with equal centres by their numbers, so that
  // the order is a total one.
  const auto key = [this, axis](std::int32_t triangle)
  {
    double sum = 0;
    for (const std::int32_t vertex : surface_.triangles[triangle])
    {
      sum += surface_.vertices[vertex][axis] / 3;
    }
    return std::make_pair(sum, triangle);
  };
  const std::int32_t middle = begin + (end - begin) / 2;
  std::nth_element(triangles_.begin() + begin, triangles_.begin() + middle,
    triangles_.begin() + end, [&key](std::int32_t a, std::int32_t b) { return key(a) < key(b); });
  this->makeNode(begin, middle);
  const std::int32_t second = this->makeNode(middle, end);
  nodes_[number].second = second;
  return number;
}

int CrossingTree::crossingOf(std::int32_t triangle, const Eigen::Vector3d& from) const
{
  const Triangle& corners = surface_.triangles[triangle];
  const RayTriangle target(surface_.vertices[corners[0]] * scale_,
    surface_.vertices[corners[1]] * scale_, surface_.vertices[corners[2]] * scale_);
  return target.crossing(from * scale_);
}

} // namespace winding
