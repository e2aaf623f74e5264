// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace winding
{

/// The ways to make one solid of several operands.
enum class BooleanOperation
{
  unite,     ///< what is inside of any operand
  intersect, ///< what is inside of all operands
  subtract,  ///< what is inside of the first operand, and of no other
  exclude    ///< what is inside of an odd number of operands
};

/// Returns whether a place is inside of the result of `operation`: `inside` of `operands` operands
/// have it inside, the first one if `isInFirst` says so.
inline bool isInResult(
  BooleanOperation operation, std::size_t operands, std::size_t inside, bool isInFirst)
{
  switch (operation)
  {
  case BooleanOperation::unite:
    return inside > 0;
  case BooleanOperation::intersect:
    return inside == operands;
  case BooleanOperation::subtract:
    return isInFirst && inside == 1;
  case BooleanOperation::exclude:
    break;
  }
  return inside % 2 != 0;
}

} // namespace winding
