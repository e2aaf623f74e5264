// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace winding
{

/// Returns the bytes of the character of UTF-8 that begins at a place; 0 if there is none.
inline std::size_t lengthOfCharacter(std::string_view text, std::size_t at)
{
  const auto first = static_cast<unsigned char>(text[at]);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xc2 ? 0
                             : first < 0xe0 ? 2
                             : first < 0xf0 ? 3
                             : first < 0xf5 ? 4
                                            : 0;
  for (std::size_t i = 1; i < length; ++i)
  {
    if (at + i >= text.size() || (static_cast<unsigned char>(text[at + i]) & 0xc0) != 0x80)
    {
      return 0;
    }
  }
  return length;
}

/// Returns a text in UTF-8. Bytes that are none are taken for Latin-1, as older programs write it.
inline std::string inUtf8(std::string_view text)
{
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const std::size_t length = lengthOfCharacter(text, i);
    if (length == 0)
    {
      const auto byte = static_cast<unsigned char>(text[i]);
      result += static_cast<char>(0xc0 | byte >> 6);
      result += static_cast<char>(0x80 | (byte & 0x3f));
    }
    else
    {
      result += text.substr(i, length);
      i += length - 1;
    }
  }
  return result;
}

} // namespace winding
