// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Memory.h"
#include "voxels/VoxelEvaluation.h"

#include <cstddef>
#include <memory>

namespace winding
{

class LabelMerge;

struct SolidEvaluationOptions
{
  VoxelEvaluation voxels;  ///< without the arrays that results go to
  bool withValues = false; ///< whether a LabelMerge is to get values of w
  FreeMemory freeMemory;   ///< what coverage may take; null for any amount
};

/**
 * Evaluates solids, one after the other, and hands their voxels to a LabelMerge. A solid whose
 * values are integers from rows is evaluated near its bounds only, since it is 0 elsewhere; and no
 * more than 16 million voxels are held at a time, or one layer of the grid where it has more.
 */
class SolidEvaluation
{
public:
  explicit SolidEvaluation(const SolidEvaluationOptions& options)
    : options_(options)
  {
  }

  /// Returns the memory that voxels take meanwhile at a grid of `samples`, without the merge.
  static double bytes(const SolidEvaluationOptions& options, std::size_t samples);

  /// Takes the executor's progress through its share, and adds up samples in `sides` if it is not
  /// null. A `plate` of more than 0 is VoxelEvaluation's. Throws Interrupted, and OutOfMemory.
  void run(const Field& field, double plate, const Grid& grid, const Extent& extent,
    LabelMerge& merge, SideTally* sides, Executor& executor);

private:
  void reserve(std::size_t samples);
  Extent extentOf(const Field& field, const Grid& grid, const Extent& extent) const;

  SolidEvaluationOptions options_;
  std::size_t reserved_ = 0;
  std::unique_ptr<unsigned char[]> inside_;
  std::unique_ptr<float[]> values_, shares_;
};

} // namespace winding
