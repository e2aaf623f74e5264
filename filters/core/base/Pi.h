#pragma once

namespace winding
{

/// The solid angle of a whole sphere is 4π; C++17 has no constant for π.
template <class Real> constexpr Real piAs = Real(3.14159265358979323846264338327950288L);

constexpr double pi = piAs<double>;

} // namespace winding
