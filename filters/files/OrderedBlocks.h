// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Executor.h"

#include <cstddef>
#include <functional>

namespace winding
{

/**
 * Calls work(0) … work(count − 1) on the executor. Blocks may throw. The exception of the first
 * block that has one, in the order of the blocks, comes out of this function for any number of
 * threads; blocks behind it may be left undone. Throws Interrupted.
 */
void runOrderedBlocks(
  std::size_t count, const std::function<void(std::size_t)>& work, Executor& executor);

} // namespace winding
