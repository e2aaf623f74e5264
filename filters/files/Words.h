// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace winding
{

/// Whether a letter stands between words on a line. The end of a line, '\n', is none.
inline bool isBlank(char letter)
{
  return letter == ' ' || letter == '\t' || letter == '\r' || letter == '\v' || letter == '\f';
}

/// The first place from `at` on, before `end`, that is not blank; `end` if there is none.
inline const char* skipBlanks(const char* at, const char* end)
{
  while (at < end && isBlank(*at))
  {
    ++at;
  }
  return at;
}

/// The end of the word that begins at `at`, before `end` or there.
inline const char* endOfWord(const char* at, const char* end)
{
  while (at < end && !isBlank(*at))
  {
    ++at;
  }
  return at;
}

/// The next word from `at` on, before `end`; moves `at` behind it. Empty if there is none.
inline std::string_view takeWord(const char*& at, const char* end)
{
  const char* const first = skipBlanks(at, end);
  at = endOfWord(first, end);
  return {first, static_cast<std::size_t>(at - first)};
}

/// The number of words from `at` to `end`.
inline std::size_t countWords(const char* at, const char* end)
{
  std::size_t words = 0;
  while (!takeWord(at, end).empty())
  {
    ++words;
  }
  return words;
}

/**
 * Reads a word that is a number: correctly rounded, the same in every locale, with or without a
 * sign, NaN and infinities too, also as 1.#QNAN and 1.#INF. Numbers below the smallest double are
 * 0, as rounding makes them.
 * False for all else, and for numbers beyond the largest double.
 */
bool parseNumber(std::string_view word, double& value);

/// Reads the next word from `at` on, before `end`, as parseNumber() does, and moves `at` behind it.
/// Where that is no number, `at` stays, and the result is false.
bool takeNumber(const char*& at, const char* end, double& value);

/// Reads a word that is a whole number, with or without a sign. False if it is none, or does not
/// fit into the value.
bool parseInteger(std::string_view word, std::int64_t& value);

/// A text with small letters for capital ones, of those that ASCII has.
std::string inSmallLetters(std::string text);

/// A word as messages may show it: in quotation marks, short, and without control characters.
std::string shown(std::string_view word);

} // namespace winding
