// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "field/FieldVolume.h"
#include "source/Grid.h"

#include <cstddef>
#include <vector>

namespace winding
{

class Executor;

/// The largest label, and so the largest number of solids: 0 is none.
constexpr int largestLabel = 65535;

/// The rules by which one of several solids that a voxel is in gives its label; see
/// vtkWindingNumberLabels::OverlapRuleType.
enum class OverlapRule
{
  first,
  last,
  largestWindingNumber,
  smallestVolume
};

/// Arrays of the labels of an extent of samples; null pointers are left out, except for `labels`.
struct LabelArrays
{
  Extent extent = {0, -1, 0, -1, 0, -1};
  unsigned short* labels = nullptr;
  unsigned short* counts = nullptr; ///< solids that each voxel is in
  float* best = nullptr;            ///< w of the label's solid, for largestWindingNumber
  ///@{
  /// The two largest shares of a voxel, and the labels that have them, 0 for none. Of equal shares
  /// the one of the solid that came first is the larger.
  unsigned short* firstLabels = nullptr;
  unsigned short* secondLabels = nullptr;
  float* firstShares = nullptr;
  float* secondShares = nullptr;
  ///@}
};

/// The findings about one solid for an extent of samples, within the arrays' extent.
struct SolidVoxels
{
  Extent extent = {0, -1, 0, -1, 0, -1};
  const unsigned char* inside = nullptr;
  const float* values = nullptr; ///< w, for largestWindingNumber
  const float* shares = nullptr; ///< for arrays of shares
};

/**
 * Puts one solid after the other into arrays of labels. Nothing depends on the pieces that a
 * solid's voxels come in, or on the executor.
 */
class LabelMerge
{
public:
  /// Sets the arrays to what they are without any solid. `byMagnitude`: whether the size of w
  /// counts for largestWindingNumber, and not w itself. Throws Interrupted.
  LabelMerge(const LabelArrays& arrays, OverlapRule rule, bool byMagnitude, Executor& executor);

  /// Begins with another solid, whose size is for smallestVolume. The array
  /// is for the shares of this solid alone, and null if they are not wanted.
  void begin(unsigned short label, const SolidSize& size, float* shares);

  /// Adds voxels of the solid, each of which is added once. Throws Interrupted.
  void add(const SolidVoxels& voxels, Executor& executor);

  /// Whether any voxel was inside the solid.
  bool hasInside() const { return hasInside_; }

private:
  bool addRow(const SolidVoxels& voxels, std::size_t from, std::size_t to, std::size_t count) const;
  void addShares(const float* shares, std::size_t to, std::size_t count) const;

  LabelArrays arrays_;
  OverlapRule rule_;
  bool byMagnitude_;
  unsigned short label_ = 0;
  SolidSize size_;
  float* shares_ = nullptr; ///< of this solid alone
  bool hasInside_ = false;
  std::vector<SolidSize> sizes_; ///< by label
};

} // namespace winding
