// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level/VoxelTree.h"

#include <cstddef>
#include <vector>

/// The vertex of a tree that is the leaf of a voxel of its brick.
inline std::size_t leafOf(const winding::VoxelTree& tree, const Eigen::Vector3i& voxel, int depth)
{
  // Each parent's children come behind the children of the parents before it.
  std::vector<std::size_t> firstChild(tree.size());
  std::size_t next = 1;
  for (std::size_t vertex = 0; vertex < tree.isParent.size(); ++vertex)
  {
    firstChild[vertex] = next;
    next += tree.isParent[vertex] ? 8 : 0;
  }
  std::size_t vertex = 0;
  while (vertex < tree.isParent.size() && tree.isParent[vertex])
  {
    --depth;
    const Eigen::Vector3i half = voxel.unaryExpr([depth](int i) { return i >> depth & 1; });
    vertex = firstChild[vertex] + static_cast<std::size_t>(half[0] + 2 * half[1] + 4 * half[2]);
  }
  return vertex;
}
