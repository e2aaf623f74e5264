// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <random>

namespace winding
{

/// Numbers in [0, 1) that are the same with every standard library.
class UnitRandom
{
public:
  explicit UnitRandom(unsigned seed)
    : engine_(seed)
  {
  }
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  int below(int count) { return std::min(static_cast<int>((*this)() * count), count - 1); }

private:
  std::mt19937_64 engine_;
};

} // namespace winding
