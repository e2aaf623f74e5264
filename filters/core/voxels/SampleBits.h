// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>

namespace winding
{

/**
 * A bit for each of the k³ samples of some voxels, in words of the caller: each voxel has
 * wordsPerVoxel(), in which its k² rows of k samples follow one another. Threads may set bits of
 * different voxels at a time.
 */
class SampleBits
{
public:
  /// `words` may be null: then there are no bits.
  SampleBits(std::uint64_t* words, int samplesPerAxis)
    : words_(words)
    , perVoxel_(wordsPerVoxel(samplesPerAxis))
    , perAxis_(static_cast<std::size_t>(samplesPerAxis))
  {
  }

  static std::size_t wordsPerVoxel(int samplesPerAxis)
  {
    const auto k = static_cast<std::size_t>(samplesPerAxis);
    return (k * k * k + bits - 1) / bits;
  }

  explicit operator bool() const { return words_ != nullptr; }

  /// Sets the bits of samples that are in `mask`, of a row of a voxel; the lowest one is the first.
  void set(std::size_t voxel, int row, std::uint64_t mask) const
  {
    const std::size_t first = static_cast<std::size_t>(row) * perAxis_, shift = first % bits;
    std::uint64_t* const word = words_ + voxel * perVoxel_ + first / bits;
    word[0] |= mask << shift;
    if (shift + perAxis_ > bits)
    {
      word[1] |= mask >> (bits - shift);
    }
  }

  /// Returns how many bits of a voxel are set.
  int count(std::size_t voxel) const
  {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < perVoxel_; ++i)
    {
      sum += std::bitset<bits>(words_[voxel * perVoxel_ + i]).count();
    }
    return static_cast<int>(sum);
  }

private:
  static constexpr std::size_t bits = 64;

  std::uint64_t* words_;
  std::size_t perVoxel_, perAxis_;
};

} // namespace winding
