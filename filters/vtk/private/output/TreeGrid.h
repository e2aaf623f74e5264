// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level/Bricks.h"
#include "level/VoxelTree.h"
#include "private/output/ResultArrays.h"

#include "vtkBitArray.h"
#include "vtkSmartPointer.h"
#include "vtkWindingABINamespace.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkHyperTreeGrid;
VTK_ABI_NAMESPACE_END

namespace winding
{

/**
 * A vtkHyperTreeGrid made of the trees of a grid's bricks, one after the other. Each tree is in
 * breadth-first order and has the numbers behind the previous tree's, so that the order of
 * all vertices is the order in VTK's files.
 */
class TreeGrid
{
public:
  /// Lays out a hyper tree grid that has no trees yet. `masksOutside` says whether what is not
  /// inside is masked, as is what lies beyond the grid. Pointers are kept.
  TreeGrid(const Grid& grid, const Bricks& bricks, const ResultOptions& options, bool masksOutside,
    vtkHyperTreeGrid* output);

  /// Adds the tree of the next brick.
  void add(const VoxelTree& tree);

  /// Adds mask and arrays, once all trees are there.
  void finish();

  /// The winding number of the leaf that holds a voxel.
  double valueAt(const Eigen::Vector3i& voxel) const;

  /// Returns whether the leaf that holds a voxel is inside (ResultArrays::isInside()).
  bool isInside(const Eigen::Vector3i& voxel, InsideRule rule, double threshold) const;

  /// The number of vertices of all trees.
  vtkIdType size() const { return size_; }

  /// The number of leaves that are not masked.
  vtkIdType leaves() const { return leaves_; }

private:
  void addMask(const VoxelTree& tree);
  vtkIdType leafOf(const Eigen::Vector3i& voxel) const;

  Bricks bricks_;
  bool masksOutside_;
  bool hasMask_ = false;
  vtkHyperTreeGrid* output_;
  ResultArrays results_;
  vtkSmartPointer<vtkBitArray> mask_;
  vtkIdType trees_ = 0;
  vtkIdType size_ = 0;
  vtkIdType leaves_ = 0;
};

} // namespace winding
