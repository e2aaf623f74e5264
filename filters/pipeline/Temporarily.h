// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

namespace winding
{

/// Sets a variable until the end of a block.
template <class Value> class Temporarily
{
public:
  Temporarily(Value& variable, Value value)
    : variable_(variable)
    , before_(std::exchange(variable, value))
  {
  }
  ~Temporarily() { variable_ = before_; }
  Temporarily(const Temporarily&) = delete;
  Temporarily& operator=(const Temporarily&) = delete;

private:
  Value& variable_;
  Value before_;
};

} // namespace winding
