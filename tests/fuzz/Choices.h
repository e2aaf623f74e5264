// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/Samples.h"

#include <cstddef>
#include <cstdint>

namespace fuzz
{

/**
 * The choices that make a random case. They come from a string of bytes: the first eight seed a
 * generator, and each byte behind them replaces the leading bits of one choice, in order. So a seed
 * alone tells a whole case, and a fuzzer that changes a byte changes one choice only.
 */
class Choices
{
public:
  explicit Choices(std::uint64_t seed)
    : state_(seed)
  {
  }

  Choices(const std::uint8_t* data, std::size_t size)
    : Choices(0)
  {
    std::size_t i = 0;
    for (; i < size && i < 8; ++i)
    {
      state_ |= std::uint64_t(data[i]) << (8 * i);
    }
    next_ = data + i;
    end_ = data + size;
  }

  /// 64 bits: those of splitmix64 (Steele, Lea and Flood, Fast splittable pseudorandom number
  /// generators, 2014), the leading ones from the next byte if there is one.
  std::uint64_t bits()
  {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return next_ == end_ ? z : (z >> 8) | std::uint64_t(*next_++) << 56;
  }

  /// One of 0 … count − 1.
  int below(int count)
  {
    return static_cast<int>((this->bits() >> 32) * static_cast<std::uint64_t>(count) >> 32);
  }

  std::size_t below(std::size_t count) { return this->bits() % count; }

  /// True once in `count` times.
  bool oneIn(int count) { return this->below(count) == count - 1; }

  /// A number in [low, high).
  double between(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(this->bits() >> 11) * 0x1p-53);
  }

  shapes::Point point(double low, double high)
  {
    const double x = this->between(low, high), y = this->between(low, high);
    return {x, y, this->between(low, high)};
  }

  /// One of some items.
  template <class T, std::size_t count> const T& oneOf(const T (&items)[count])
  {
    return items[this->below(static_cast<int>(count))];
  }

private:
  std::uint64_t state_;
  const std::uint8_t* next_ = nullptr;
  const std::uint8_t* end_ = nullptr;
};

} // namespace fuzz
