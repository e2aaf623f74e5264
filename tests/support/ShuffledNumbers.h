// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace shapes
{

/// The numbers 0 … count − 1 in random order. below(n) gives random numbers from 0 to n − 1, which
/// both have type std::size_t.
template <class Below>
std::vector<std::size_t> shuffledNumbers(std::size_t count, const Below& below)
{
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t(0));
  for (std::size_t i = count; i > 1; --i)
  {
    std::swap(numbers[i - 1], numbers[below(i)]);
  }
  return numbers;
}

} // namespace shapes
