// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <charconv>
#include <string>
#include <type_traits>

/**
 * @file
 * Numbers as text, with a point in every locale: hosts as Qt choose the user's, where printf() and
 * streams may write a comma.
 */

namespace winding
{

/// Returns `value` with `digits` significant digits at most, up to 40, as "%.*g" of printf() does.
inline std::string inDigits(double value, int digits = 6)
{
  char text[64];
  return {
    text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr};
}

/// Returns `value` with `places` digits after the point, up to 40, as "%.*f" of printf() does.
inline std::string inPlaces(double value, int places)
{
  char text[400]; // the largest value has 309 digits before the point
  return {
    text, std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, places).ptr};
}

/// Returns words and numbers one after the other, floating-point numbers by inDigits().
template <class... Parts> std::string joined(const Parts&... parts)
{
  std::string text;
  const auto append = [&text](const auto& part)
  {
    using Part = std::decay_t<decltype(part)>;
    if constexpr (std::is_floating_point_v<Part>)
    {
      text += inDigits(part);
    }
    else if constexpr (std::is_integral_v<Part> && !std::is_same_v<Part, char>)
    {
      text += std::to_string(part);
    }
    else
    {
      text += part;
    }
  };
  (append(parts), ...);
  return text;
}

} // namespace winding
