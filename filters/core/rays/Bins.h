// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Bounds.h"

#include <hwy/base.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace winding
{

/// A range of bins along each axis, both ends among them.
struct BinBox
{
  std::uint32_t low, high; ///< bins of x, y and z, 10 bits each

  int first(int axis) const { return static_cast<int>(low >> 10 * axis & 0x3ff); }
  int last(int axis) const { return static_cast<int>(high >> 10 * axis & 0x3ff); }

  /// Returns the level (BinnedItems) on which the range has at most three bins along each axis.
  int level() const
  {
    const std::uint32_t steps = high - low;
    const std::uint32_t most = (steps | steps >> 10 | steps >> 20) & 0x3ff;
    return static_cast<int>(31 - hwy::Num0BitsAboveMS1Bit_Nonzero32(most | 1));
  }
};

/// Bins in a box: up to 512 along each side. The outer ones reach on to infinity.
class Bins
{
public:
  static constexpr int most = 512;

  /// Makes bins along each axis for triangles of `extents` on average.
  Bins(const Bounds& box, const Eigen::Vector3d& extents)
    : origin_(box.min())
  {
    const Eigen::Vector3d sizes = box.sizes();
    for (int axis = 0; axis < 3; ++axis)
    {
      constexpr double fewest = 8;
      const double wanted = extents[axis] > 0 ? sizes[axis] / extents[axis] : most;
      count_[axis] = static_cast<int>(std::clamp(wanted, fewest, 1.0 * most));
      const double perLength = count_[axis] / sizes[axis];
      perLength_[axis] = std::isfinite(perLength) ? perLength : 0;
      last_[axis] = count_[axis] - 1;
    }
  }

  /// Returns the bin of a coordinate. It never falls as the coordinate rises.
  int bin(int axis, double coordinate) const
  {
    const double bin = (coordinate - origin_[axis]) * perLength_[axis];
    return static_cast<int>(std::clamp(bin, 0.0, last_[axis]));
  }

  /// Returns the bins of a place in one number.
  std::uint32_t binsOf(const Eigen::Vector3d& place) const
  {
    const Eigen::Vector3d bins =
      (place - origin_).cwiseProduct(perLength_).cwiseMax(0.0).cwiseMin(last_);
    return static_cast<std::uint32_t>(static_cast<int>(bins[0]) | static_cast<int>(bins[1]) << 10 |
                                      static_cast<int>(bins[2]) << 20);
  }

  /// Returns where a bin starts, up to rounding.
  double start(int axis, double bin) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return bin <= 0              ? -infinity
           : bin >= count_[axis] ? infinity
                                 : origin_[axis] + bin / perLength_[axis];
  }

  /// Returns the range of three places by their bins.
  static BinBox boxOf(std::uint32_t a, std::uint32_t b, std::uint32_t c)
  {
    const std::uint32_t lower = lowerOf(a, b), higher = a ^ b ^ lower;
    return {lowerOf(lower, c), higher ^ c ^ lowerOf(higher, c)};
  }

private:
  /// Returns the lower of each pair of 10 bits below 2⁹.
  static std::uint32_t lowerOf(std::uint32_t a, std::uint32_t b)
  {
    constexpr std::uint32_t tops = 1u << 9 | 1u << 19 | 1u << 29;
    const std::uint32_t isNotLess = (((a | tops) - b) & tops) >> 9;
    const std::uint32_t mask = isNotLess * 0x3ff;
    return (b & mask) | (a & ~mask);
  }

  Eigen::Vector3d origin_, perLength_, last_;
  int count_[3];
};

/// Items in rows of bins, for the boxes of triangles to find.
class BinnedItems
{
public:
  /// Makes place for up to `items` items, each in one bin.
  explicit BinnedItems(std::size_t items)
    : filled_(words(0))
    , slots_(std::size_t(1) << static_cast<int>(std::ceil(std::log2(2.0 * (items + 1)))))
  {
    links_.reserve(items);
    std::size_t size = 0;
    for (int level = 0; level <= levels; ++level)
    {
      starts_[level] = size;
      size += words(level);
    }
    nearby_.resize(size);
  }

  void add(int row, int bin, std::int32_t item)
  {
    Slot& slot = slots_[this->slotOf(keyOf(row, bin))];
    links_.push_back({item, slot.head});
    slot = {keyOf(row, bin), static_cast<std::int32_t>(links_.size()) - 1};
    filled_[keyOf(row, bin) / 64] |= std::uint64_t(1) << keyOf(row, bin) % 64;
    for (int level = 0; level <= levels; ++level)
    {
      const int ownRow = row >> level, own = bin >> level;
      for (int before = std::max(ownRow - 2, 0); before <= ownRow; ++before)
      {
        for (int left = std::max(own - 2, 0); left <= own; ++left)
        {
          const std::uint32_t key = keyOf(before, left, level);
          nearby_[starts_[level] + key / 64] |= std::uint64_t(1) << key % 64;
        }
      }
    }
  }

  /// Returns 1 if there are items in three rows of three bins from one on; 0 otherwise. On a level
  /// bins are joined, 2^level along each axis.
  std::uint64_t areNear(int row, int bin, int level) const
  {
    const std::uint32_t key = keyOf(row >> level, bin >> level, level);
    return nearby_[starts_[level] + key / 64] >> key % 64 & 1;
  }

  /// Calls visit(item) for each item in the bins of a row from the first to the last.
  template <class Visit> void forEach(int row, int first, int last, const Visit& visit) const
  {
    const std::uint32_t begin = keyOf(row, first), end = keyOf(row, last);
    for (std::uint32_t word = begin / 64; word <= end / 64; ++word)
    {
      std::uint64_t filled = filled_[word];
      filled &= word == begin / 64 ? ~std::uint64_t(0) << begin % 64 : ~std::uint64_t(0);
      filled &= word == end / 64 ? ~std::uint64_t(0) >> (63 - end % 64) : ~std::uint64_t(0);
      for (; filled != 0; filled &= filled - 1)
      {
        const auto bit = static_cast<std::uint32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero64(filled));
        for (std::int32_t link = slots_[this->slotOf(64 * word + bit)].head; link >= 0;
             link = links_[static_cast<std::size_t>(link)].next)
        {
          visit(links_[static_cast<std::size_t>(link)].item);
        }
      }
    }
  }

private:
  using Bits = std::vector<std::uint64_t>; ///< by bin, row after row
  static constexpr int levels = 9;         ///< of one bin; Bins::most is 2^levels

  struct Link
  {
    std::int32_t item, next;
  };

  /// A bin with items.
  struct Slot
  {
    std::uint32_t key = 0;
    std::int32_t head = -1;
  };

  static std::size_t words(int level)
  {
    return std::max<std::size_t>(1, std::size_t(Bins::most) * Bins::most >> 2 * level >> 6);
  }
  static std::uint32_t keyOf(int row, int bin, int level = 0)
  {
    return static_cast<std::uint32_t>(row * (Bins::most >> level) + bin);
  }

  /// Returns the slot of a bin, or the empty one that it may take.
  std::size_t slotOf(std::uint32_t key) const
  {
    std::size_t slot = (key * 0x9e3779b1u >> 7) & (slots_.size() - 1);
    while (slots_[slot].head >= 0 && slots_[slot].key != key)
    {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    return slot;
  }

  Bits filled_;
  Bits nearby_; ///< all levels, one after the other
  std::size_t starts_[levels + 1];
  std::vector<Slot> slots_; ///< a hash table, half of it empty
  std::vector<Link> links_;
};

} // namespace winding
