// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>

/**
 * @file
 * An operator new that can fail, for a test program whose sources include FailingAllocations.cxx.
 * The program's libraries use it, too.
 */
namespace allocations
{

extern std::atomic<long> left;       ///< allocations before one fails; less than 0 for never
extern std::atomic<long> blocks;     ///< blocks that were allocated and not given back
extern thread_local bool neverFails; ///< whether this thread's allocations do not count in `left`

} // namespace allocations
