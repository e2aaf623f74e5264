// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"
#include "field/Field.h"
#include "voxels/SampleBits.h"

#include <cstdint>

namespace winding
{

class RowCrossings;

/**
 * The share of each voxel of an extent that is inside: the share of its k³ samples, evenly spaced,
 * that are inside by the rule. So it is a multiple of 1/k³.
 *
 * Samples are counted, not their w averaged: near holes w fades outside of the solid, and where
 * solids overlap it is 2, neither of which is a share of a voxel. For one closed surface, oriented
 * outward, count and average are the same.
 *
 * The samples are a grid k times as fine. Where the method is rows and the surface is closed, its
 * rows are added up without being written anywhere: the time is as for k² times the rows. All
 * other fields are evaluated part by part, which costs about what a field of k³ times as many
 * samples does, and takes a byte for each sample of a part, 64 MiB at most unless one row of voxels
 * is more.
 *
 * Bits of samples keep what earlier fields have inside. Then the shares are what several fields
 * cover, evaluated one after the other.
 *
 * Guaranteed: the shares are the same for any extent, executor and number of threads. A sample is
 * inside by its value as an array of floats stores it.
 */
class CoverageFractions
{
public:
  /// The largest number of samples along an axis of a voxel. Up to its square, samples are counted
  /// in bytes, which hold 255.
  static constexpr int mostSamples = 10;

  /// `samplesPerAxis` is k, 1 to mostSamples; `fractions` gets a number for each voxel of the
  /// extent, and `united` has the bits of its samples, unless it is null. References and pointers
  /// are kept. Throws Refusal for a grid too fine for its samples to be numbered.
  CoverageFractions(const Field& field, const Grid& grid, const Extent& extent, int samplesPerAxis,
    const InsideTest& isInside, float* fractions, std::uint64_t* united = nullptr);

  /// The number of parts, which take about the same time each.
  int parts() const { return partsAlongY_ * partsAlongZ_; }

  /// Computes the voxels of a part. Throws Interrupted.
  void evaluate(int part, Executor& executor) const;

private:
  Extent extentOf(int part) const;
  Extent samplesOf(const Extent& voxels) const;
  void addUpRows(const RowCrossings& rows, Executor& executor) const;
  void addUpSamples(const Extent& voxels, Executor& executor) const;
  void unite(const unsigned char* inside, std::size_t first, int row, std::size_t width) const;
  float share(int samples) const;

  const Field& field_;
  Grid samples_;
  Extent extent_;
  int perAxis_;
  InsideTest isInside_;
  float* fractions_;
  SampleBits united_;
  int partsAlongY_ = 1, partsAlongZ_ = 1;
  int rowsPerPart_ = 0, layersPerPart_ = 0;
};

/// Returns the expected memory of CoverageFractions for `voxels` voxels.
std::size_t bytesOfFractions(const Field& field, std::size_t voxels, int samplesPerAxis);

} // namespace winding
