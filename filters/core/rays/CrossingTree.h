// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "source/Surface.h"

#include <cstdint>
#include <vector>

namespace winding
{

/**
 * Triangles of closed parts of a surface, sorted so that those which a ray along +x meets are found
 * in logarithmic time, however unlike in size they are: a tree of boxes over their projections
 * along the rays. A ray ignores parts in whose bounds it does not begin, as their winding number is
 * 0 there.
 */
class CrossingTree
{
public:
  /// Takes the number of its part for each triangle, and for each part its bounds, empty for parts
  /// that are left out. Keeps references, which must outlive this. Takes O(n log n) time, 4 bytes
  /// per triangle and 64 per node; a node stands for 2 to 4 triangles.
  CrossingTree(const Surface& surface, const std::vector<std::int32_t>& partOfTriangle,
    const std::vector<Bounds>& boundsOfPart);

  /// Takes some of the triangles alone.
  CrossingTree(const Surface& surface, const std::vector<std::int32_t>& partOfTriangle,
    const std::vector<Bounds>& boundsOfPart, std::vector<std::int32_t> triangles);

  /**
   * Calls visit(part, crossing) for the triangles that the ray from a vertex meets, with a crossing
   * of +1 or −1 (RayTriangle.h), in no particular order. The vertex itself counts as moved by the
   * infinitesimal steps of sideOfPlane(), so triangles that have it as a corner may be among them.
   */
  template <class Visit> void forEachCrossing(std::int32_t vertex, const Visit& visit) const
  {
    const Eigen::Vector3d& from = surface_.vertices[vertex];
    std::int32_t stack[64]; // large enough, for every step down the tree halves the triangles
    int size = 0;
    if (!nodes_.empty())
    {
      stack[size++] = 0;
    }
    while (size > 0)
    {
      const Node& node = nodes_[stack[--size]];
      if (!node.isMetFrom(from))
      {
        continue;
      }
      if (node.second >= 0)
      {
        stack[size++] = node.second;
        stack[size++] = static_cast<std::int32_t>(&node - nodes_.data()) + 1;
        continue;
      }
      for (std::int32_t i = node.begin; i < node.end; ++i)
      {
        const std::int32_t part = partOfTriangle_[triangles_[i]];
        const int crossing =
          boundsOfPart_[part].contains(from) ? this->crossingOf(triangles_[i], from) : 0;
        if (crossing != 0)
        {
          visit(part, crossing);
        }
      }
    }
  }

private:
  /// A node of the tree; its first child comes right after it.
  struct Node
  {
    double startX; ///< lowest x of its parts' bounds: rays that begin before it ignore the node
    double highX, lowY, highY, lowZ, highZ;
    std::int32_t begin, end; ///< its triangles in triangles_
    std::int32_t second;     ///< its second child; −1 for a leaf

    bool isMetFrom(const Eigen::Vector3d& from) const
    {
      return from[0] >= startX && from[0] <= highX && from[1] >= lowY && from[1] <= highY &&
             from[2] >= lowZ && from[2] <= highZ;
    }
  };

  std::int32_t makeNode(std::int32_t begin, std::int32_t end);
  int crossingOf(std::int32_t triangle, const Eigen::Vector3d& from) const;

  const Surface& surface_;
  const std::vector<std::int32_t>& partOfTriangle_;
  const std::vector<Bounds>& boundsOfPart_;
  double scale_; ///< brings the surface to about unit size (UnitScale.h)
  std::vector<std::int32_t> triangles_;
  std::vector<Node> nodes_;
};

} // namespace winding
