#include "files/Words.h"

#include <algorithm>
#include <charconv>

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

} // namespace

bool parseNumber(std::string_view word, double& value)
{
  const char* const last = word.data() + word.size();
  const char* const first = withoutPlus(word.data(), last);
  const auto result = std::from_chars(first, last, value);
  if (result.ptr != last || result.ec == std::errc::invalid_argument)
  {
    return false;
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
