// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Refusal.h"

#include <string>
#include <vector>

namespace winding
{

/// A result that does not fit into memory.
class OutOfMemory : public Refusal
{
public:
  using Refusal::Refusal;
};

/// The memory of the machine, in bytes.
struct HostMemory
{
  double total = 0;
  double used = 0; ///< by all programs; what the system can give back at once is not counted
};

/// Asks the system.
HostMemory hostMemory();

/// Returns a number of bytes for people, as "317 GiB" or "12.5 MiB".
std::string memoryInWords(double bytes);

/// Returns whether `bytes` bytes are free for this process: the ranks of a program on the machine
/// share what is free. `memory` says what there is; less than 64 MiB is taken to be free without
/// asking it.
bool isMemoryFree(double bytes, HostMemory (*memory)() = hostMemory);

/// Throws OutOfMemory, with the numbers, if `bytes` are not free by isMemoryFree(). `what` needs
/// them, and `remedies` are what to do about it.
void refuseBeyondFreeMemory(double bytes, const std::string& what, std::vector<Remedy> remedies,
  HostMemory (*memory)() = hostMemory);

} // namespace winding
