// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause

// A fuzzer of one check of the core: its name comes from CMake. A failure ends the program with a
// message, and libFuzzer keeps the case.

#include "Checks.h"

#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Choices choices(data, size);
  const std::string failure = fuzz::WINDING_FUZZ_CHECK(choices);
  if (!failure.empty())
  {
    std::fprintf(stderr, "%s\n", failure.c_str());
    std::abort();
  }
  return 0;
}
