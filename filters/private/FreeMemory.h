#pragma once

#include "base/Refusal.h"

namespace winding
{

/// A result that does not fit into memory.
class OutOfMemory : public Refusal
{
public:
  using Refusal::Refusal;
};

/// Throws OutOfMemory, with the numbers, if that many bytes are not free. `what` needs them;
/// `advice` says what to do about it.
void refuseBeyondFreeMemory(double bytes, const std::string& what, const std::string& advice);

} // namespace winding
