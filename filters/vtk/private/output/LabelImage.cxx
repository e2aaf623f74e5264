// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "private/output/LabelImage.h"

#include "pipeline/FreeMemory.h"
#include "private/output/ResultArrays.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"

#include <algorithm>

namespace winding
{

double bytesPerSample(const LabelImageOptions& options)
{
  std::size_t bytes = sizeof(unsigned short);
  bytes += options.withCounts ? sizeof(unsigned short) : 0;
  bytes += options.withLargestTwo ? 2 * (sizeof(unsigned short) + sizeof(float)) : 0;
  bytes += options.withShares ? options.solids * sizeof(float) : 0;
  bytes += options.withBest ? sizeof(float) : 0;
  return static_cast<double>(bytes);
}

LabelImage::LabelImage(const Extent& extent, const LabelImageOptions& options)
  : withShares_(options.withShares)
{
  const std::size_t samples = sampleCount(extent);
  refuseBeyondFreeMemory(bytesPerSample(options) * static_cast<double>(samples),
    "the labels of " + std::to_string(samples) + " voxels", {largerVoxels(), inPieces()});
  arrays_.extent = extent;
  arrays_.labels = this->add<unsigned short>(VTK_UNSIGNED_SHORT, "Label");
  if (options.withCounts)
  {
    arrays_.counts = this->add<unsigned short>(VTK_UNSIGNED_SHORT, "SolidCount");
  }
  if (options.withLargestTwo)
  {
    arrays_.firstLabels = this->add<unsigned short>(VTK_UNSIGNED_SHORT, "FirstLabel");
    arrays_.firstShares = this->add<float>(VTK_FLOAT, "FirstShare");
    arrays_.secondLabels = this->add<unsigned short>(VTK_UNSIGNED_SHORT, "SecondLabel");
    arrays_.secondShares = this->add<float>(VTK_FLOAT, "SecondShare");
  }
  if (options.withBest)
  {
    best_.resize(samples);
    arrays_.best = best_.data();
  }
}

template <class T> T* LabelImage::add(int type, const std::string& name)
{
  made_.push_back(makeResultArray(type, name, static_cast<vtkIdType>(sampleCount(arrays_.extent))));
  return static_cast<T*>(made_.back()->GetVoidPointer(0));
}

float* LabelImage::addSharesOf(unsigned short label)
{
  if (!withShares_)
  {
    return nullptr;
  }
  float* shares = this->add<float>(VTK_FLOAT, "Coverage " + std::to_string(label));
  std::fill_n(shares, sampleCount(arrays_.extent), 0.0F);
  return shares;
}

void LabelImage::addTo(vtkDataSetAttributes* attributes) const
{
  for (const auto& array : made_)
  {
    attributes->AddArray(array);
  }
  attributes->SetActiveScalars("Label");
}

} // namespace winding
