// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace winding
{

/// π in any type of floating-point numbers, as C++17 has no constant for it.
template <class Real> constexpr Real piAs = Real(3.14159265358979323846264338327950288L);

constexpr double pi = piAs<double>;

} // namespace winding
