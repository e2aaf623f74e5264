// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause

// Changes files as formats are made: words and lines are removed, repeated, exchanged and replaced
// by numbers and words that are hard on readers. Half of the changes are libFuzzer's own, of bytes.

#include "Choices.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace
{

/// A range of bytes of the text.
using Range = std::pair<std::size_t, std::size_t>;

bool isSpace(char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/// The words, which spaces, quotes and brackets end, or the lines with their ends.
std::vector<Range> rangesOf(const std::string& text, bool lines)
{
  std::vector<Range> ranges;
  std::size_t first = 0;
  for (std::size_t i = 0; i <= text.size(); ++i)
  {
    const char c = i < text.size() ? text[i] : '\n';
    const bool isEnd =
      lines ? c == '\n' : isSpace(c) || c == '"' || c == '<' || c == '>' || c == ',';
    if (isEnd)
    {
      const std::size_t end = std::min(text.size(), lines ? i + 1 : i);
      if (end > first)
      {
        ranges.emplace_back(first, end);
      }
      first = i + 1;
    }
  }
  return ranges;
}

std::string hardWord(fuzz::Choices& choices)
{
  static const char* const words[] = {"0", "1", "-1", "2", "3", "4", "7", "255", "256", "65536",
    "2147483647", "-2147483648", "4294967296", "9223372036854775807", "-9223372036854775808", "1e9",
    "1e300", "-1e308", "1e-320", "1e400", "nan", "inf", "-inf", "0x10", "1.5", "+1", "1,5", "",
    "\"", "\r", "x", "ascii", "binary", "binary_big_endian", "list", "int", "float", "vtktypeint64",
    "end_header", "POLYHEDRON", "42", "METADATA", "FIELD", "appended"};
  return choices.oneOf(words);
}

void change(std::string& text, fuzz::Choices& choices)
{
  const std::vector<Range> ranges = rangesOf(text, choices.oneIn(3));
  if (ranges.empty())
  {
    return;
  }
  const Range a = ranges[choices.below(ranges.size())], b = ranges[choices.below(ranges.size())];
  const std::string other = text.substr(b.first, b.second - b.first);
  switch (choices.below(6))
  {
  case 0:
    text.erase(a.first, a.second - a.first);
    break;
  case 1:
    text.insert(a.first, other);
    break;
  case 2:
    text.replace(a.first, a.second - a.first, other);
    break;
  case 3:
    text.resize(a.first); // cut off in the middle
    break;
  default:
    text.replace(a.first, a.second - a.first, hardWord(choices));
  }
}

} // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(
  std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed)
{
  fuzz::Choices choices(seed);
  if (choices.oneIn(2))
  {
    return LLVMFuzzerMutate(data, size, most);
  }
  std::string text(data, data + size);
  for (int changes = 1 + choices.below(3); changes > 0; --changes)
  {
    change(text, choices);
  }
  text.resize(std::min(text.size(), most));
  std::copy(text.begin(), text.end(), data);
  return text.size();
}
