// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/Refusal.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace winding
{

/// A result that does not fit into memory.
class OutOfMemory : public Refusal
{
public:
  using Refusal::Refusal;
};

/// Returns a number of bytes for people, as "317 GiB" or "12.5 MiB".
inline std::string memoryInWords(double bytes)
{
  constexpr double mebi = 1024.0 * 1024.0;
  const bool isLarge = bytes >= 1000 * mebi;
  return inDigits(bytes / (isLarge ? 1024 * mebi : mebi), 3) + (isLarge ? " GiB" : " MiB");
}

/// Returns the memory that is free, in bytes.
using FreeMemory = std::function<double()>;

/// Returns whether `bytes` bytes are free. Less than 64 MiB is taken to be free without asking.
inline bool isFree(double bytes, const FreeMemory& freeMemory)
{
  constexpr double smallest = 64.0 * 1024 * 1024;
  return bytes < smallest || !freeMemory || bytes <= freeMemory();
}

/// Throws OutOfMemory, with the numbers, unless `bytes` are free. `what` needs them, and `remedies`
/// are what to do about it.
inline void refuseUnlessFree(
  double bytes, const FreeMemory& freeMemory, const std::string& what, std::vector<Remedy> remedies)
{
  if (!isFree(bytes, freeMemory))
  {
    throw OutOfMemory(Message("not enough memory", std::move(remedies),
      what + " needs " + memoryInWords(bytes) + ", and " + memoryInWords(freeMemory()) +
        " is free"));
  }
}

} // namespace winding
