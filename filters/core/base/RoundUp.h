// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace winding
{

/// The number of lanes of the widest vectors that kernels of single precision use; their arrays are
/// filled up to a multiple of it.
constexpr std::size_t floatLanes = 16;

/// The smallest multiple of `step` that is not less than `count`.
constexpr std::size_t roundUp(std::size_t count, std::size_t step)
{
  return (count + step - 1) / step * step;
}

} // namespace winding
