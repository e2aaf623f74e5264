// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/Words.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace winding
{

namespace
{

/// from_chars knows no plus sign.
const char* withoutPlus(const char* first, const char* last)
{
  return last - first > 1 && first[0] == '+' && first[1] != '-' ? first + 1 : first;
}

/// Whether a number beyond the range of doubles is below the smallest one. The sign of the place of
/// its first digit that counts decides.
bool isTiny(std::string_view word)
{
  const std::size_t end = std::min(word.find_first_of("eE"), word.size());
  const std::string_view mantissa = word.substr(0, end);
  const std::size_t first = std::min(mantissa.find_first_of("123456789"), mantissa.size());
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const auto place = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);
  std::int64_t exponent = 0;
  if (end < word.size() && !parseInteger(word.substr(end + 1), exponent))
  {
    return word.size() > end + 1 && word[end + 1] == '-';
  }
  return place < -exponent;
}

/// Whether `rest`, behind a 1, makes it one that is none, as older C libraries write it: 1.#IND,
/// 1.#QNAN or 1.#INF. `value` then becomes that.
bool isOldNotANumber(const char* rest, const char* last, double& value)
{
  const std::string_view mark(rest, static_cast<std::size_t>(last - rest));
  if (mark.size() < 4 || mark[0] != '#' || rest[-1] != '.')
  {
    return false;
  }
  value = mark.substr(0, 4) == "#INF" ? std::copysign(HUGE_VAL, value)
                                      : std::numeric_limits<double>::quiet_NaN();
  return mark[1] == 'I' || mark[1] == 'Q' || mark[1] == 'S';
}

} // namespace

bool parseNumber(std::string_view word, double& value)
{
  const char* const last = word.data() + word.size();
  const char* const first = withoutPlus(word.data(), last);
  const auto result = std::from_chars(first, last, value);
  if (result.ptr != last || result.ec == std::errc::invalid_argument)
  {
    return result.ec == std::errc() && isOldNotANumber(result.ptr, last, value);
  }
  if (result.ec == std::errc())
  {
    return true;
  }
  value = *first == '-' ? -0.0 : 0.0;
  return isTiny(word);
}

bool takeNumber(const char*& at, const char* end, double& value)
{
  const char* next = skipBlanks(at, end);
  const auto result = std::from_chars(next, end, value);
  if (result.ec == std::errc() && (result.ptr == end || isBlank(*result.ptr)))
  {
    at = result.ptr;
    return true;
  }
  if (!parseNumber(takeWord(next, end), value))
  {
    return false;
  }
  at = next;
  return true;
}

bool parseInteger(std::string_view word, std::int64_t& value)
{
  const char* const last = word.data() + word.size();
  const auto result = std::from_chars(withoutPlus(word.data(), last), last, value);
  return result.ec == std::errc() && result.ptr == last;
}

std::string inSmallLetters(std::string text)
{
  for (char& c : text)
  {
    c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  }
  return text;
}

std::string shown(std::string_view word)
{
  std::string text(word.substr(0, 20));
  for (char& c : text)
  {
    c = c >= ' ' && c <= '~' ? c : '?';
  }
  return "\"" + text + (word.size() > 20 ? "...\"" : "\"");
}

} // namespace winding
