// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Memory.h"

#include <string>
#include <vector>

namespace winding
{

/// The memory of the machine, in bytes.
struct HostMemory
{
  double total = 0;
  double used = 0; ///< by all programs; what the system can give back at once is not counted
};

/// Asks the system.
HostMemory hostMemory();

/// Returns the memory that is free for this process: the ranks of a program on the machine share
/// what is free. `memory` says what there is.
double freeBytes(HostMemory (*memory)() = hostMemory);

/// Throws OutOfMemory, with the numbers, unless `bytes` are free. `what` needs them, and `remedies`
/// are what to do about it.
void refuseBeyondFreeMemory(double bytes, const std::string& what, std::vector<Remedy> remedies,
  HostMemory (*memory)() = hostMemory);

} // namespace winding
