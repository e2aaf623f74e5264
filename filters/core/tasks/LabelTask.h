// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/LabelFacts.h"
#include "tasks/Task.h"
#include "voxels/LabelMerge.h"
#include "voxels/SolidEvaluation.h"

#include <string>
#include <vector>

namespace winding
{

/// The rules by which voxels get labels.
struct LabelOptions
{
  VoxelEvaluation voxels; ///< without the arrays that results go to
  OverlapRule overlapRule = OverlapRule::first;
  bool mendsSource = false; ///< whether solids are mended (MendedSource.h)
};

/// A solid that gives a label.
struct LabeledSolid
{
  unsigned short label;
  std::string name;        ///< for warnings
  bool isOpenPart = false; ///< whether it is open inside of others, and needs no voxel
  float* shares = nullptr; ///< array for its shares of voxels; null for none
};

/// Labels the voxels of an extent of a grid by several solids, one after the other. What a grid
/// does not show is found out where the extent is the whole grid.
class LabelTask
{
public:
  /// Keeps references to `grid` and `facts`, whose number of expected solids is set. Sets the
  /// arrays to what they are without any solid. Throws Interrupted.
  LabelTask(const Grid& grid, const LabelArrays& arrays, const LabelOptions& options,
    LabelFacts& facts, Run& run);

  /// Returns the memory that voxels of `samples` samples take meanwhile, without the arrays.
  static double bytes(const LabelOptions& options, std::size_t samples);

  /// Adds a solid, as the executor's share of progress, and counts it among the facts; `info` is of
  /// its field, with the warnings that are to be repeated. Keeps no reference. Throws Interrupted,
  /// and OutOfMemory.
  void add(const Field& field, const FieldInfo& info, const LabeledSolid& solid, Run& run);

  /// Warns of solids that are empty, open or without a label, once all are there, and of units
  /// unless `haveOneUnit`.
  void warn(bool haveOneUnit, Run& run) const;

private:
  bool isWhole() const { return arrays_.extent == grid_.wholeExtent(); }
  void inspectResult(
    const Field& field, const SideCounts& sides, const LabeledSolid& solid, Run& run);
  void warnOfLabels(Run& run) const;

  const Grid& grid_;
  LabelArrays arrays_;
  LabelOptions options_;
  InsideTest isInside_;
  LabelFacts& facts_;
  LabelMerge merge_;
  SolidEvaluation evaluation_;
  std::vector<LabeledSolid> shown_; ///< those that have voxels inside
};

} // namespace winding
