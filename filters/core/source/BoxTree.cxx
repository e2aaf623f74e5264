// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "source/BoxTree.h"

#include "source/CoordinateOrder.h"

namespace winding
{

namespace
{

constexpr std::size_t itemsPerLeaf = 4;

std::vector<Eigen::Vector3d> middlesOf(const Surface& surface, Executor& executor)
{
  std::vector<Eigen::Vector3d> middles(surface.triangles.size());
  forEachItem(
    middles.size(),
    [&](std::size_t i)
    {
      const Triangle& ids = surface.triangles[i];
      const std::vector<Eigen::Vector3d>& vertices = surface.vertices;
      const Eigen::Vector3d &a = vertices[std::size_t(ids[0])], &b = vertices[std::size_t(ids[1])],
                            &c = vertices[std::size_t(ids[2])];
      // Halves first, as sums of large coordinates have no number.
      middles[i] = 0.5 * a.cwiseMin(b).cwiseMin(c) + 0.5 * a.cwiseMax(b).cwiseMax(c);
    },
    executor);
  return middles;
}

} // namespace

BoxTree::BoxTree(const Surface& surface, Executor& executor)
  : surface_(&surface)
  , tree_(middlesOf(surface, executor), itemsPerLeaf, executor,
      [&surface](std::uint32_t a, std::uint32_t b)
      {
        const std::vector<Eigen::Vector3d>& vertices = surface.vertices;
        return compareTriangles(vertices, lowestFirst(vertices, surface.triangles[a]),
                 lowestFirst(vertices, surface.triangles[b])) < 0;
      })
{
  this->makeBoxes(executor);
}

BoxTree::BoxTree(const PointCloud& cloud, Executor& executor)
  : cloud_(&cloud)
  , tree_(cloud.positions, itemsPerLeaf, executor)
{
  this->makeBoxes(executor);
}

std::size_t BoxTree::bytesFor(std::size_t primitives)
{
  // There are about one and a half nodes for every leaf, and leaves are half full.
  constexpr std::size_t perLeaf = 3 * (sizeof(SourceNode) + sizeof(Bounds)) / 2;
  return primitives * (sizeof(std::uint32_t) + 2 * perLeaf / itemsPerLeaf);
}

/// Makes the boxes, from the deepest nodes up.
void BoxTree::makeBoxes(Executor& executor)
{
  const std::vector<SourceNode>& nodes = tree_.nodes();
  const std::vector<std::size_t>& starts = tree_.depthStarts();
  boxes_.resize(nodes.size());
  for (std::size_t depth = starts.size() - 1; depth-- > 0;)
  {
    forEachItem(
      starts[depth + 1] - starts[depth],
      [&](std::size_t i)
      {
        const SourceNode& node = nodes[starts[depth] + i];
        Bounds& box = boxes_[starts[depth] + i];
        for (std::uint32_t child = 0; child < node.children; ++child)
        {
          box.extend(boxes_[node.firstChild + child]);
        }
        for (std::uint32_t item = node.begin; node.children == 0 && item < node.end; ++item)
        {
          box.extend(this->boxOf(tree_.order()[item]));
        }
      },
      executor);
  }
}

} // namespace winding
