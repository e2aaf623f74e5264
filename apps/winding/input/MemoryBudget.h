#pragma once

#include <cstdint>

#include <sys/resource.h>

/**
 * While a budget lives, memory beyond it is refused with std::bad_alloc. Readers that believe what
 * a damaged file says would otherwise fill the machine's memory before they look for the data.
 */
class MemoryBudget
{
public:
  /// The budget is for the contents of a file of this many bytes, packed or not.
  explicit MemoryBudget(std::uintmax_t fileSize);
  ~MemoryBudget();
  MemoryBudget(const MemoryBudget&) = delete;
  void operator=(const MemoryBudget&) = delete;

private:
  struct rlimit before_ = {};
};
