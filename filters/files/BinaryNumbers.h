// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace winding
{

/// Whether this machine stores numbers with their first byte most significant.
constexpr bool isBigEndianMachine = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__;

/// The number whose bytes begin at `at`, aligned or not, in the order of this machine or, if
/// `isSwapped`, in the opposite one.
template <class Number, bool isSwapped> Number numberAt(const char* at)
{
  char bytes[sizeof(Number)];
  std::memcpy(bytes, at, sizeof bytes);
  if (isSwapped)
  {
    std::reverse(bytes, bytes + sizeof bytes);
  }
  Number number;
  std::memcpy(&number, bytes, sizeof number);
  return number;
}

} // namespace winding
