#include "files/TextScanning.h"

#include <algorithm>
#include <charconv>

std::string_view takeLine(std::string_view text, std::size_t& start)
{
  const std::size_t end = std::min(text.find('\n', start), text.size());
  std::string_view line = text.substr(start, end - start);
  start = end + 1;
  if (!line.empty() && line.back() == '\r')
  {
    line.remove_suffix(1);
  }
  return line;
}

std::string_view takeWord(std::string_view& text)
{
  const auto isSpace = [](char c)
  {
    return c == ' ' || (c >= '\t' && c <= '\r');
  };
  const auto first = std::find_if_not(text.begin(), text.end(), isSpace);
  const auto last = std::find_if(first, text.end(), isSpace);
  const std::string_view word = text.substr(
    static_cast<std::size_t>(first - text.begin()), static_cast<std::size_t>(last - first));
  text.remove_prefix(static_cast<std::size_t>(last - text.begin()));
  return word;
}

bool parseInteger(std::string_view word, long long& value)
{
  if (word.size() > 1 && word[0] == '+' && word[1] != '-')
  {
    word.remove_prefix(1); // from_chars() knows no plus sign
  }
  const char* const end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

std::string inSmallLetters(std::string_view text)
{
  std::string small(text);
  for (char& c : small)
  {
    c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  }
  return small;
}
