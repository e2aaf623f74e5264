// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "field/Field.h"

#include <cstdint>

namespace winding
{

/// The rules by which a voxel is inside; see vtkWindingNumberField::CoverageType.
enum class Coverage
{
  center,
  any,
  fraction
};

/// The voxels of an extent of a grid, to be made into arrays.
struct VoxelEvaluation
{
  Coverage coverage = Coverage::center;
  int samplesPerAxis = 4;          ///< for fractions; see CoverageFractions.h
  FieldOutput output;              ///< values at the centres, and inside for whole voxels
  float* fractions = nullptr;      ///< shares of the voxels; set for fractions only
  double plate = 0;                ///< thickness of the plate that is inside; 0: the field decides
  std::uint64_t* united = nullptr; ///< bits of samples (SampleBits.h), for shares of several fields

  /// Returns the memory that is expected in addition to the field of `voxels` voxels.
  std::size_t additionalBytes(const Field& field, std::size_t voxels) const;

  /// Takes the executor's progress through its share. Throws Interrupted.
  void run(const Field& field, const Grid& grid, const Extent& extent, Executor& executor) const;

private:
  void evaluatePlate(
    const Field& field, const Grid& grid, const Extent& extent, Executor& executor) const;
  void evaluateFractions(
    const Field& field, const Grid& grid, const Extent& extent, Executor& executor) const;
};

} // namespace winding
