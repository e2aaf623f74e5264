// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "level/VoxelTree.h"

#include <utility>

namespace winding
{

VoxelTreeBuilder::VoxelTreeBuilder(int depth, const Eigen::Vector3i& ends)
  : depth_(depth)
  , ends_(ends)
{
}

VoxelTreeBuilder::Place VoxelTreeBuilder::placeOf(const VoxelCube& cube) const
{
  const Eigen::Vector3i first = cube.firstVoxel();
  if ((first.array() >= ends_.array()).any())
  {
    return Place::beyond;
  }
  const bool isWithin = (first.array() + (1 << cube.level) <= ends_.array()).all();
  return isWithin ? Place::within : Place::across;
}

void VoxelTreeBuilder::beginLevel()
{
  ++tree_.levels;
  lastLevel_ = tree_.size();
}

void VoxelTreeBuilder::add(const VoxelState& state, double voxels, bool isParent)
{
  tree_.isParent.push_back(isParent);
  tree_.isBeyond.push_back(false);
  tree_.values.push_back(state.value);
  tree_.inside.push_back(state.isInside);
  tree_.coverage.push_back(state.coverage);
  voxels_.push_back(voxels);
}

void VoxelTreeBuilder::addBeyond()
{
  this->add({}, 0, false);
  tree_.isBeyond.back() = true;
}

void VoxelTreeBuilder::addLeaf(const VoxelCube& cube, const VoxelState& state)
{
  this->add(state, static_cast<double>(std::int64_t{1} << (3 * cube.level)), false);
}

void VoxelTreeBuilder::addParent(const VoxelCube& cube, std::vector<VoxelCube>& children)
{
  this->add({}, 0, true);
  for (int child = 0; child < 8; ++child)
  {
    const Eigen::Vector3i step(child & 1, child >> 1 & 1, child >> 2);
    children.push_back({cube.level - 1, 2 * cube.index + step});
  }
}

VoxelTree VoxelTreeBuilder::finish()
{
  std::vector<double> insideVoxels(tree_.size());
  std::size_t end = tree_.size(); // the children that no parent has taken yet end here
  for (std::size_t vertex = tree_.size(); vertex-- > 0;)
  {
    if (!tree_.isParent[vertex])
    {
      insideVoxels[vertex] = tree_.inside[vertex] ? voxels_[vertex] : 0;
      continue;
    }
    double value = 0, coverage = 0;
    for (std::size_t child = end - 8; child < end; ++child)
    {
      voxels_[vertex] += voxels_[child];
      insideVoxels[vertex] += insideVoxels[child];
      value += voxels_[child] * tree_.values[child];
      coverage += voxels_[child] * static_cast<double>(tree_.coverage[child]);
    }
    end -= 8;
    tree_.values[vertex] = value / voxels_[vertex];
    tree_.coverage[vertex] = static_cast<float>(coverage / voxels_[vertex]);
    tree_.inside[vertex] = 2 * insideVoxels[vertex] >= voxels_[vertex];
  }
  tree_.isParent.resize(lastLevel_);
  return std::move(tree_);
}

} // namespace winding
