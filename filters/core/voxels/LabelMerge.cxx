// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/LabelMerge.h"

#include "base/Executor.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace winding
{

namespace
{

constexpr std::size_t samplesPerBlock = 1 << 16;

template <class T> void fillWith(T* array, T value, std::size_t samples, Executor& executor)
{
  if (array)
  {
    runBlocks(
      samples, 16 * samplesPerBlock,
      [&](std::size_t, std::size_t first, std::size_t last)
      { std::fill(array + first, array + last, value); },
      executor);
  }
}

/// The loops are written without branches, so that compilers make vector instructions of them.
bool addFirst(
  const unsigned char* inside, unsigned short* labels, unsigned short label, std::size_t count)
{
  unsigned char any = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto mask = static_cast<unsigned short>(-(inside[i] & (labels[i] == 0)));
    labels[i] = static_cast<unsigned short>(labels[i] | (mask & label));
    any |= inside[i];
  }
  return any != 0;
}

bool addLast(
  const unsigned char* inside, unsigned short* labels, unsigned short label, std::size_t count)
{
  unsigned char any = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto mask = static_cast<unsigned short>(-inside[i]);
    labels[i] = static_cast<unsigned short>((labels[i] & ~mask) | (mask & label));
    any |= inside[i];
  }
  return any != 0;
}

} // namespace

LabelMerge::LabelMerge(
  const LabelArrays& arrays, OverlapRule rule, bool byMagnitude, Executor& executor)
  : arrays_(arrays)
  , rule_(rule)
  , byMagnitude_(byMagnitude)
{
  const std::size_t samples = sampleCount(arrays.extent);
  for (unsigned short* array :
    {arrays.labels, arrays.counts, arrays.firstLabels, arrays.secondLabels})
  {
    fillWith<unsigned short>(array, 0, samples, executor);
  }
  for (float* array : {arrays.best, arrays.firstShares, arrays.secondShares})
  {
    fillWith<float>(array, 0, samples, executor);
  }
}

void LabelMerge::begin(unsigned short label, const SolidSize& size, float* shares)
{
  label_ = label;
  size_ = size;
  shares_ = shares;
  hasInside_ = false;
  if (rule_ == OverlapRule::smallestVolume)
  {
    sizes_.resize(std::max<std::size_t>(sizes_.size(), label + std::size_t{1}));
    sizes_[label] = size;
  }
}

void LabelMerge::add(const SolidVoxels& voxels, Executor& executor)
{
  const Extent& extent = voxels.extent;
  const auto width = static_cast<std::size_t>(extent[1] - extent[0] + 1);
  const auto depth = static_cast<std::size_t>(extent[3] - extent[2] + 1);
  const std::size_t rows = sampleCount(extent) / std::max<std::size_t>(1, width);
  std::atomic<bool> any{false};
  runBlocks(
    rows, samplesPerBlock / width + 1,
    [&](std::size_t, std::size_t first, std::size_t last)
    {
      bool isAny = false;
      for (std::size_t row = first; row < last; ++row)
      {
        const int j = extent[2] + static_cast<int>(row % depth);
        const int k = extent[4] + static_cast<int>(row / depth);
        const std::size_t to = sampleNumber(arrays_.extent, extent[0], j, k);
        isAny |= this->addRow(voxels, row * width, to, width);
      }
      if (isAny)
      {
        any = true;
      }
    },
    executor);
  hasInside_ |= any;
}

/// Adds a row of voxels from one place in a solid's arrays to one in the labels'.
bool LabelMerge::addRow(
  const SolidVoxels& voxels, std::size_t from, std::size_t to, std::size_t count) const
{
  const unsigned char* inside = voxels.inside + from;
  unsigned short* labels = arrays_.labels + to;
  if (arrays_.counts)
  {
    std::transform(inside, inside + count, arrays_.counts + to, arrays_.counts + to,
      [](unsigned char in, unsigned short n) { return static_cast<unsigned short>(n + in); });
  }
  if (arrays_.firstShares)
  {
    this->addShares(voxels.shares + from, to, count);
  }
  if (shares_)
  {
    std::copy_n(voxels.shares + from, count, shares_ + to);
  }
  if (rule_ == OverlapRule::first)
  {
    return addFirst(inside, labels, label_, count);
  }
  if (rule_ == OverlapRule::last)
  {
    return addLast(inside, labels, label_, count);
  }
  bool any = false;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!inside[i])
    {
      continue;
    }
    any = true;
    bool wins = labels[i] == 0;
    if (rule_ == OverlapRule::smallestVolume)
    {
      wins = wins || size_ < sizes_[labels[i]];
    }
    else
    {
      const float w = byMagnitude_ ? std::abs(voxels.values[from + i]) : voxels.values[from + i];
      wins = wins || w > arrays_.best[to + i];
      arrays_.best[to + i] = wins ? w : arrays_.best[to + i];
    }
    labels[i] = wins ? label_ : labels[i];
  }
  return any;
}

void LabelMerge::addShares(const float* shares, std::size_t to, std::size_t count) const
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const float share = shares[i];
    const std::size_t at = to + i;
    if (share > arrays_.firstShares[at])
    {
      arrays_.secondShares[at] = arrays_.firstShares[at];
      arrays_.secondLabels[at] = arrays_.firstLabels[at];
      arrays_.firstShares[at] = share;
      arrays_.firstLabels[at] = label_;
    }
    else if (share > arrays_.secondShares[at])
    {
      arrays_.secondShares[at] = share;
      arrays_.secondLabels[at] = label_;
    }
  }
}

} // namespace winding
