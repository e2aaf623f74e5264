// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"

#include <cstdint>
#include <vector>

namespace winding
{

/// The numbers of a voxel, or of a cube of voxels.
struct VoxelState
{
  double value = 0; ///< the winding number
  bool isInside = false;
  float coverage = 0; ///< the share that is inside, where it is wanted
};

/**
 * The voxels of a brick as an octree. A leaf is a cube of voxels that are taken together. Vertices
 * come breadth first: the root, then level by level, the eight children of a parent one after the
 * other, along x first, then y, then z, as in vtkHyperTree.
 *
 * A parent has the means of its voxels, and is inside where half of them or more are. Vertices that
 * lie beyond the grid as a whole are leaves with the numbers 0.
 */
struct VoxelTree
{
  int levels = 0;
  std::vector<bool> isParent; ///< of all vertices except on the last level, which have none
  std::vector<bool> isBeyond; ///< whether a vertex lies beyond the grid
  std::vector<double> values; ///< winding numbers
  std::vector<std::uint8_t> inside;
  std::vector<float> coverage;

  std::size_t size() const { return values.size(); }
};

/// A cube of 2^level voxels a side; `index` counts these cubes from the first voxel of a brick.
struct VoxelCube
{
  int level;
  Eigen::Vector3i index;

  Eigen::Vector3i firstVoxel() const { return index * (1 << level); }
};

/// Adds vertices to a tree breadth first, and gives parents their means at the end.
class VoxelTreeBuilder
{
public:
  /// The root has 2^depth voxels a side, and the ones below `ends` lie in the grid.
  VoxelTreeBuilder(int depth, const Eigen::Vector3i& ends);

  /// Makes the tree. Its leaves are single voxels, and larger cubes where isUniform(cube) is true;
  /// stateOf(cube) gives the numbers of a leaf. Both are asked only about cubes that lie in the
  /// grid as a whole.
  template <class IsUniform, class StateOf>
  VoxelTree build(const IsUniform& isUniform, const StateOf& stateOf)
  {
    std::vector<VoxelCube> cubes = {{depth_, Eigen::Vector3i::Zero()}};
    for (std::vector<VoxelCube> children; !cubes.empty(); cubes.swap(children), children.clear())
    {
      this->beginLevel();
      for (const VoxelCube& cube : cubes)
      {
        switch (this->placeOf(cube))
        {
        case Place::beyond:
          this->addBeyond();
          break;
        case Place::within:
          if (cube.level == 0 || isUniform(cube))
          {
            this->addLeaf(cube, stateOf(cube));
            break;
          }
          [[fallthrough]];
        case Place::across:
          this->addParent(cube, children);
          break;
        }
      }
    }
    return this->finish();
  }

private:
  enum class Place
  {
    within,
    across,
    beyond
  };

  Place placeOf(const VoxelCube& cube) const;
  void beginLevel();
  void addBeyond();
  void addLeaf(const VoxelCube& cube, const VoxelState& state);
  void addParent(const VoxelCube& cube, std::vector<VoxelCube>& children);
  void add(const VoxelState& state, double voxels, bool isParent);
  VoxelTree finish();

  int depth_;
  Eigen::Vector3i ends_;
  VoxelTree tree_;
  std::size_t lastLevel_ = 0;  ///< first vertex of the level at work
  std::vector<double> voxels_; ///< voxels of the grid in each vertex
};

} // namespace winding
