// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"
#include "base/Executor.h"
#include "source/PointCloud.h"
#include "source/SourceTree.h"
#include "source/Surface.h"

#include <cstdint>
#include <vector>

namespace winding
{

/**
 * The triangles of a surface or the points of a cloud in a hierarchy of boxes, to find those that
 * are near a box. Immutable once built; queries may run on several threads at once. Their order
 * depends on coordinates alone. Takes about bytesFor() of memory.
 */
class BoxTree
{
public:
  /// Keeps a reference, which must outlive this. Throws Interrupted.
  BoxTree(const Surface& surface, Executor& executor);
  BoxTree(const PointCloud& cloud, Executor& executor);

  /// Returns the approximate memory of a tree over `primitives` primitives, in bytes.
  static std::size_t bytesFor(std::size_t primitives);

  /// Calls visit(number) for each triangle whose own box, or each point that, meets a box, the
  /// sides of both included; up to the first call that returns false.
  template <class Visit> void forEachIn(const Bounds& box, const Visit& visit) const
  {
    // Each step down leaves three children or fewer behind, and halves a side of the tree's box:
    // doubles end long before there are this many.
    std::uint32_t stack[3 * 2200];
    int size = 0;
    if (!boxes_.empty() && boxes_[0].intersects(box))
    {
      stack[size++] = 0;
    }
    while (size > 0)
    {
      const SourceNode& node = tree_.nodes()[stack[--size]];
      for (std::uint32_t child = node.firstChild + node.children; child-- > node.firstChild;)
      {
        if (boxes_[child].intersects(box))
        {
          stack[size++] = child;
        }
      }
      for (std::uint32_t i = node.begin; node.children == 0 && i < node.end; ++i)
      {
        const std::uint32_t item = tree_.order()[i];
        if (this->boxOf(item).intersects(box) && !visit(item))
        {
          return;
        }
      }
    }
  }

  /// Returns whether a triangle's box or a point meets a box.
  bool reaches(const Bounds& box) const
  {
    bool isMet = false;
    this->forEachIn(box,
      [&isMet](std::uint32_t)
      {
        isMet = true;
        return false;
      });
    return isMet;
  }

private:
  void makeBoxes(Executor& executor);
  Bounds boxOf(std::uint32_t item) const
  {
    if (!surface_)
    {
      return Bounds(cloud_->positions[item]);
    }
    const Triangle& ids = surface_->triangles[item];
    const std::vector<Eigen::Vector3d>& vertices = surface_->vertices;
    return Bounds(vertices[std::size_t(ids[0])])
      .extend(vertices[std::size_t(ids[1])])
      .extend(vertices[std::size_t(ids[2])]);
  }

  const Surface* surface_ = nullptr;
  const PointCloud* cloud_ = nullptr;
  SourceTree tree_;
  std::vector<Bounds> boxes_;
};

} // namespace winding
