// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxels/LabelMerge.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWindingABINamespace.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkDataSetAttributes;
VTK_ABI_NAMESPACE_END

namespace winding
{

/// The arrays of vtkWindingNumberLabels that are wanted in addition to the labels.
struct LabelImageOptions
{
  bool withCounts = false;
  bool withLargestTwo = false; ///< the two largest shares and their labels
  bool withShares = false;     ///< an array of shares for each solid
  bool withBest = false;       ///< for OverlapRule::largestWindingNumber, not for the output
  std::size_t solids = 0;
};

/// The memory of the arrays for each sample.
double bytesPerSample(const LabelImageOptions& options);

/// The arrays of labels of an extent of samples.
class LabelImage
{
public:
  /// Throws OutOfMemory, with the numbers, for too many samples.
  LabelImage(const Extent& extent, const LabelImageOptions& options);

  const LabelArrays& arrays() const { return arrays_; }

  /// A new array for the shares of the solid of that label, all 0; null if they are not wanted.
  float* addSharesOf(unsigned short label);

  /// Adds the arrays; the labels become the active scalars.
  void addTo(vtkDataSetAttributes* attributes) const;

private:
  template <class T> T* add(int type, const std::string& name);

  bool withShares_;
  LabelArrays arrays_;
  std::vector<vtkSmartPointer<vtkDataArray>> made_;
  std::vector<float> best_;
};

} // namespace winding
