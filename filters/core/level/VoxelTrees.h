// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "base/SideCounts.h"
#include "field/Field.h"
#include "level/Bricks.h"
#include "level/VoxelTree.h"

#include <functional>
#include <memory>
#include <vector>

namespace winding
{

/// The wishes for the trees of a grid's voxels.
struct VoxelTreeOptions
{
  bool withValues = true;    ///< whether the winding numbers are wanted
  bool asDouble = false;     ///< whether they belong to an array of doubles, not of floats
  bool withCoverage = false; ///< whether the shares that are inside are wanted
  bool byCenters = true;     ///< whether a voxel is inside where its centre is
  InsideRule rule = InsideRule::signedThreshold;
  double threshold = 0.5;
  /// Voxels whose winding numbers differ by no more than this may share a leaf, 0 or more; see
  /// VoxelTrees.
  double tolerance = 0;
};

/// The arrays of an extent's voxels, to be filled. Null pointers are left out.
struct VoxelArrays
{
  float* values = nullptr;
  double* doubleValues = nullptr;
  unsigned char* inside = nullptr;
  float* coverage = nullptr;
};

/**
 * The voxels of a grid as octrees, a group of bricks after the other, in the order of their
 * numbers: never are all voxels in memory.
 *
 * Guaranteed: (1) a voxel has the same side in its leaf as in the field, and the same coverage; (2)
 * it has the same winding number where whole rows of the field are integers (Field::integerRows())
 * or the tolerance is 0, to the bit; (3) elsewhere all voxels of a leaf lie within one interval as
 * long as the tolerance, and the leaf has its middle, so that it differs from theirs by half the
 * tolerance at most; (4) the trees depend on the source, the grid and the options only.
 *
 * Where whole rows are integers and centres decide what is inside, leaves follow from the runs of
 * rows (RunsOfLayers.h), and no voxel is looked at: the time is the rows', and of the
 * surface in voxels. Any other field is evaluated in extents of about 128 MB, or one brick where
 * that is more.
 */
class VoxelTrees
{
public:
  /// Fills the arrays of an extent of the grid, or throws Interrupted.
  using Evaluate = std::function<void(const Extent& extent, const VoxelArrays& arrays)>;

  /// References are kept.
  VoxelTrees(const Field& field, const Grid& grid, const VoxelTreeOptions& options,
    const Evaluate& evaluate);

  const Bricks& bricks() const { return bricks_; }

  bool isDone() const { return nextGroup_ == groups_; }

  ///@{
  /// The share of the work that is done, and that will be after the next advance().
  double progress() const { return this->shareOf(nextGroup_); }
  double nextProgress() const { return this->shareOf(nextGroup_ + 1); }
  ///@}

  /// Makes the trees of the next bricks. Throws Interrupted.
  std::vector<VoxelTree> advance(Executor& executor);

  /// The sides of the samples whose rows gave trees; none where voxels were evaluated.
  const SideCounts& sides() const { return sides_; }

  /// The number of voxels inside of the trees until now, by coverage where it is asked.
  std::size_t inside() const { return inside_; }

  /// Whether the runs of rows give the trees.
  static bool areMadeOfRuns(const Field& field, const VoxelTreeOptions& options);

  /// The most memory, in bytes, that the voxels at work take.
  static double bytesAtWork(const Field& field, const Grid& grid, const VoxelTreeOptions& options);

private:
  Extent bricksOfNext() const;
  double shareOf(std::size_t group) const
  {
    return static_cast<double>(group) / static_cast<double>(groups_);
  }
  std::vector<VoxelTree> ofRuns(const Extent& bricks, Executor& executor);
  std::vector<VoxelTree> ofArrays(const Extent& bricks, Executor& executor);
  template <class Number>
  std::vector<VoxelTree> ofArrays(const Extent& bricks, std::vector<Number>& values,
    const VoxelArrays& arrays, Executor& executor);

  const Field& field_;
  const Grid& grid_;
  VoxelTreeOptions options_;
  Evaluate evaluate_;
  Bricks bricks_;
  Eigen::Vector3i perGroup_;    ///< bricks of a group along each axis
  Eigen::Vector3i groupCounts_; ///< groups along each axis
  std::size_t groups_ = 0;
  std::size_t nextGroup_ = 0;
  SideCounts sides_;
  std::size_t inside_ = 0;
};

} // namespace winding
