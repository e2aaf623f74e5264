#pragma once

#include "voxels/VoxelEvaluation.h"

#include <cstddef>
#include <memory>

namespace winding
{

class LabelMerge;

/// How to evaluate voxels, but for the arrays that results go to; and whether a LabelMerge is to
/// get values of w.
struct SolidEvaluationOptions
{
  VoxelEvaluation voxels;
  bool withValues = false;
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

  /// The memory that voxels of so many samples take meanwhile, without the merge.
  static double bytes(const SolidEvaluationOptions& options, std::size_t samples);

  /// Takes the executor's progress through its share. Throws Interrupted, and OutOfMemory where
  /// what is needed for the coverage is not free.
  void run(const Field& field, const Grid& grid, const Extent& extent, LabelMerge& merge,
    Executor& executor);

private:
  void reserve(std::size_t samples);
  Extent extentOf(const Field& field, const Grid& grid, const Extent& extent) const;

  SolidEvaluationOptions options_;
  std::size_t reserved_ = 0;
  std::unique_ptr<unsigned char[]> inside_;
  std::unique_ptr<float[]> values_, shares_;
};

} // namespace winding
