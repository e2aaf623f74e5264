// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "files/Text.h"

#include "program/Failure.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace
{

/// Whether a text is in UTF-16, as InputFile of the module knows it: many of its pairs of bytes
/// have one that is 0, the same one of each pair. Without a byte order mark all have.
bool isUtf16(std::string_view head)
{
  std::size_t zeros[2] = {0, 0};
  for (std::size_t i = 0; i < head.size(); ++i)
  {
    zeros[i % 2] += head[i] == '\0' ? 1 : 0;
  }
  const std::size_t pairs = head.size() / 2, found = std::max(zeros[0], zeros[1]);
  const std::string_view mark = head.substr(0, 2);
  return mark == "\xFE\xFF" || mark == "\xFF\xFE"
           ? 4 * found > pairs && found > 2 * std::min(zeros[0], zeros[1])
           : pairs > 1 && found == pairs && std::min(zeros[0], zeros[1]) == 0;
}

std::string read(const std::string& fileName, std::size_t most)
{
  std::error_code error;
  if (!std::filesystem::exists(fileName, error))
  {
    throw Failure(EXIT_REFUSED, fileName, "no such file; check its name and folder");
  }
  if (std::filesystem::is_directory(fileName, error))
  {
    throw Failure(EXIT_REFUSED, fileName, "is a folder; give a file");
  }
  if (!std::filesystem::is_regular_file(fileName, error))
  {
    // Opening a pipe would wait until somebody writes into it.
    throw Failure(EXIT_REFUSED, fileName, specialFile);
  }
  std::ifstream file(fileName, std::ios::binary);
  if (!file)
  {
    throw Failure(EXIT_REFUSED, fileName,
      std::string("cannot be opened: ") + std::strerror(errno) + "; check its permissions");
  }
  const std::uintmax_t size = std::filesystem::file_size(fileName, error);
  std::string text(error ? 0 : std::min<std::uintmax_t>(size, most), '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (text.empty() || !file)
  {
    throw Failure(EXIT_REFUSED, fileName,
      text.empty() ? "is empty; give another file" : "cannot be read to its end");
  }
  constexpr std::size_t looked = 256;
  if (isUtf16(std::string_view(text).substr(0, looked)))
  {
    throw Failure(EXIT_REFUSED, fileName, "is text in UTF-16; save it as UTF-8");
  }
  return text;
}

/// Reads a word that is one number.
template <class Number> bool parse(std::string_view word, Number& value)
{
  if (word.size() > 1 && word[0] == '+' && word[1] != '-')
  {
    word.remove_prefix(1); // from_chars() knows no plus sign
  }
  const char* const end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

} // namespace

std::string contentsOf(const std::string& fileName)
{
  return read(fileName, SIZE_MAX);
}

std::string beginningOf(const std::string& fileName, std::size_t bytes)
{
  return read(fileName, bytes);
}

std::string_view takeLine(std::string_view text, std::size_t& start)
{
  const std::size_t end = std::min(text.find_first_of("\r\n", start), text.size());
  const std::string_view line = text.substr(start, end - start);
  start = end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
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

std::string_view trimmed(std::string_view text)
{
  const std::string_view blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string_view::npos
           ? std::string_view()
           : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

bool startsWith(std::string_view text, std::string_view start)
{
  return text.substr(0, start.size()) == start;
}

bool endsWith(std::string_view text, std::string_view end)
{
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

bool parseInteger(std::string_view word, long long& value)
{
  return parse(word, value);
}

bool parseNumber(std::string_view word, double& value)
{
  if (parse(word, value))
  {
    return true;
  }
  long double wide = 0; // its range says whether a number is too small
  const bool isTiny = parse(word, wide) && std::abs(wide) < 1;
  value = 0;
  return isTiny;
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

void appendExact(std::string& text, double value)
{
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

std::string withoutPercentCodes(const std::string& name)
{
  std::string result;
  for (std::size_t i = 0; i < name.size(); ++i)
  {
    const std::string code = name[i] == '%' ? name.substr(i + 1, 2) : "";
    unsigned char letter = 0;
    const char* const end = std::from_chars(code.data(), code.data() + code.size(), letter, 16).ptr;
    const bool isCode = code.size() == 2 && end == code.data() + 2;
    result += isCode ? static_cast<char>(letter) : name[i];
    i += isCode ? 2 : 0;
  }
  return result;
}

std::string exact(double value)
{
  std::string text;
  appendExact(text, value);
  return text;
}

std::string exact(const double vector[3], char separator)
{
  return exact(vector[0]) + separator + exact(vector[1]) + separator + exact(vector[2]);
}

std::string asField(const std::string& text, char separator)
{
  const bool isPlain = text.find(separator) == std::string::npos &&
                       text.find_first_of("\"\r\n") == std::string::npos &&
                       (text.empty() || (text.front() != ' ' && text.back() != ' '));
  if (isPlain)
  {
    return text;
  }
  std::string field = "\"";
  for (const char c : text)
  {
    field += c == '"' ? std::string("\"\"") : std::string(1, c);
  }
  return field + "\"";
}
